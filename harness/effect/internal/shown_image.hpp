// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "effect/internal/frame_images.hpp"
#include "effect/internal/passes.hpp"
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

}  // namespace gloam::effect
