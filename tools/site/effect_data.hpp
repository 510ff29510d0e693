// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace gloam::site {

// The folders of the shaders that the effect of the page is made from.
struct ShaderFolders {
    std::filesystem::path library;  // with gloam/ and passes/
    std::filesystem::path page;     // with occlusion.frag
};

// The passes of the page in GLSL ES 3.00, packed, the methods that run there, and the settings of the presets
// without a filter for each of them, for a radius of 1: as JSON (page/effect.js). Throws like shader::pack().
[[nodiscard]] std::string effect_json(const ShaderFolders& folders);

// The triangles of a scene and its camera in each of `frames` frames, as JSON (page/scene.js).
[[nodiscard]] std::string scene_json(const scene::Scene& scene, int frames);

}  // namespace gloam::site
