// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "effect/history_map.hpp"
#include "effect/pixel_classes.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect {

// The guard band that is compared with none, part of the frame on each side.
constexpr double study_guard = 0.1;

// A frame of a moving scene, with what is known of its pixels besides.
struct SequenceFrame {
    scene::GBuffer view;
    scene::GBuffer wide;                // the same with a guard band of study_guard
    std::optional<HistoryMap> history;  // from the frame before; none in the first
    PixelClasses classes;
};

// The first frames of a scene, drawn once for all who are compared on them. Throws like scene::rasterize().
[[nodiscard]] std::vector<SequenceFrame> sequence_of(const gpu::Device& device,
                                                     const scene::PassLibrary& passes,
                                                     const scene::Scene& scene, gpu::Extent extent,
                                                     int frames);

// The view as it would be if nothing had moved since the frame before.
[[nodiscard]] scene::GBuffer standing_still(scene::GBuffer view);

}  // namespace gloam::effect
