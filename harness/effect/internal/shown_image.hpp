// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "effect/internal/frame_images.hpp"
#include "effect/plan.hpp"
#include "effect/settings.hpp"

namespace gloam::effect {

// The planned image whose first channel is shown.
struct ShownImage {
    std::string name;
    float unit = 1.0F;  // occlusion that a value of 1 stands for
};

// `filtered`: whether the filter runs in the frame.
[[nodiscard]] inline ShownImage shown_image(const Settings& settings, bool filtered) {
    if (settings.resolution == Resolution::half) return {"upsampled"};
    if (remaps(settings)) return {filtered ? "filtered_mapped" : "mapped"};
    if (filtered || shows_alone(settings)) return {"filtered"};
    const bool packed = settings.precision == HistoryPrecision::packed;
    return {"history_after", packed ? packed_occlusion_unit : 1.0F};
}

// Sets where the plan's frames have their results.
inline void name_results(const Settings& settings, Plan& plan) {
    const ShownImage shown = shown_image(settings, filters(settings));
    plan.result = shown.name;
    plan.result_unit = shown.unit;
    if (!filters_early(settings)) return;
    const ShownImage later = shown_image(settings, false);
    plan.filter_frames = static_cast<std::uint32_t>(std::min(std::ceil(settings.filter_frames), 2e9F));
    plan.later_result = later.name;
    plan.later_unit = later.unit;
}

}  // namespace gloam::effect
