// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "effect/methods.hpp"
#include "effect/plan.hpp"
#include "module/compile.hpp"
#include "scene/pass_library.hpp"

namespace gloam::cli {

// A pass of a plan as one text, with its constants set.
[[nodiscard]] std::string text_of(const effect::PlannedPass& pass, const scene::PassLibrary& library,
                                  shader::Language language = shader::Language::vulkan450);

struct EffectPackOptions {
    std::string preset = effect::default_preset;
    std::vector<std::string> set;  // NAME=VALUE
    bool orthographic = false;
    bool visibility = false;       // is what is shown; otherwise occlusion
    bool plain_uniforms = false;   // in the place of a block of OpenGL
    std::string normals = "view";  // scene::encoding_named(), or none: from depth
    std::string version = "450";   // of the passes: compute shaders, or fragment shaders where there are none
    std::filesystem::path out;
    std::uint32_t taps = 8;  // of one pass, for each pixel
};

// Writes the passes of a frame and gloam_frame.h with the preset into a folder, all or none. Throws
// std::invalid_argument for invalid options, std::runtime_error for a folder that cannot be written to.
void pack_effect(const EffectPackOptions& options);

// The same for the effect as one pass and its blur in two, of glsl/passes/one_pass.
void pack_one_pass(const EffectPackOptions& options);

}  // namespace gloam::cli
