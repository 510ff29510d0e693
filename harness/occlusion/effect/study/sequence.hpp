// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "effect/history_map.hpp"
#include "effect/pixel_classes.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect {

// The guard band that is compared with no guard band, share of the frame on each side.
constexpr double study_guard = 0.1;

// A frame of a moving scene, with further data about its pixels.
struct SequenceFrame {
    scene::GBuffer view;
    scene::GBuffer wide;                // the same with a guard band of study_guard
    std::optional<HistoryMap> history;  // from the previous frame; none in the first
    PixelClasses classes;
};

// The first frames of a scene, rendered once for all comparisons. Throws like scene::rasterize().
[[nodiscard]] std::vector<SequenceFrame> sequence_of(const gpu::Device& device,
                                                     const scene::PassLibrary& passes,
                                                     const scene::Scene& scene, gpu::Extent extent,
                                                     int frames);

// The view as it would be if nothing had moved since the previous frame.
[[nodiscard]] scene::GBuffer standing_still(scene::GBuffer view);

}  // namespace gloam::effect
