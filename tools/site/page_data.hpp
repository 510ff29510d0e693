// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.hpp"

namespace gloam::site {

// The folders of the shaders that the effect of the page is made from.
struct ShaderFolders {
    std::filesystem::path library;  // with gloam/ and passes/
    std::filesystem::path page;     // with whole_image.vert
};

// What AmbientOcclusion needs (effect/ambient-occlusion.js), as JSON: gloam's own presets, and the passes by
// name. Throws like shader::pack().
[[nodiscard]] std::string effect_json(const ShaderFolders& folders);

// The passes that draw a scene of the page and show it (page/picture.js), by name, as JSON.
[[nodiscard]] std::string picture_json(const ShaderFolders& folders);

// The classes of the effect in WebGL2 (effect/*.js): JavaScript that defines AmbientOcclusion and what it
// uses. Throws std::runtime_error for a file that cannot be read.
[[nodiscard]] std::string effect_classes(const std::filesystem::path& folder);

// The triangles of a scene and its camera in each of `frames` frames, as JSON (page/scene.js).
[[nodiscard]] std::string scene_json(const scene::Scene& scene, int frames);

}  // namespace gloam::site
