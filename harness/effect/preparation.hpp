// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "effect/settings.hpp"
#include "gpu/image.hpp"

namespace gloam::effect {

// A pass that runs before ambient_occlusion.comp and writes a part of the prepared image.
struct PreparationPass {
    std::string name;         // for its time; no other pass of the frame has it
    std::string file;         // in glsl/passes/preparation
    gpu::Extent invocations;  // 8 x 8 a group
    int level = 0;            // given to the pass as a constant
};

// What a method needs before its samples: passes, in order, and the image that they write for it.
struct Preparation {
    gpu::Extent image;
    gpu::Format format = gpu::Format::rgba32f;  // or r32f
    std::vector<PreparationPass> passes;
    // How far from the pixel's surface the samples of a result may lie: in pixels, and in world units.
    int spread = 0;
    float reach = 0.0F;
};

// The preparation of the method of the settings for views of that size, guard band included; none for a
// method that needs none.
[[nodiscard]] std::optional<Preparation> preparation_of(const Settings& settings, gpu::Extent view);

// Of a method's prepared image; rgba32f for one that prepares nothing.
[[nodiscard]] gpu::Format prepared_format(const std::string& method);

}  // namespace gloam::effect
