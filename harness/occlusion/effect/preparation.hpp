// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "effect/settings.hpp"
#include "gpu/resources.hpp"

namespace gloam::effect {

// A pass that runs before ambient_occlusion.comp and writes a part of the prepared image.
struct PreparationPass {
    std::string name;         // for its time; unique among the passes of the frame
    std::string file;         // in glsl/passes/preparation
    gpu::Extent invocations;  // in groups of 8 x 8
    int level = 0;            // passed to the shader as a constant
};

// What a method needs before it samples: passes in order, and the image that they write.
struct Preparation {
    gpu::Extent image;
    gpu::Format format = gpu::Format::rgba32f;  // or r32f
    std::vector<PreparationPass> passes;
    // Largest distance of a result's samples from the pixel's surface: in pixels, and in world units.
    int spread = 0;
    float reach = 0.0F;
};

// The preparation of the method of the settings for views of that size, guard band included; none for a
// method that needs none.
[[nodiscard]] std::optional<Preparation> preparation_of(const Settings& settings, gpu::Extent view);

}  // namespace gloam::effect
