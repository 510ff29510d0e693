// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace gloam::site {

// The classes of the effect in WebGL2 (effect/*.js): JavaScript that defines AmbientOcclusion and what it
// uses. files: this folder. Throws std::runtime_error for a file that cannot be read.
[[nodiscard]] std::string effect_classes(const std::filesystem::path& files);

// What AmbientOcclusion needs (effect/ambient-occlusion.js), as JSON: gloam's own presets, and the passes by
// name. library: the folder with gloam/ and passes/. Throws like module::pack().
[[nodiscard]] std::string effect_json(const std::filesystem::path& library,
                                      const std::filesystem::path& files);

// The passes that draw a scene of the page and show it (page/picture.js), likewise.
[[nodiscard]] std::string picture_json(const std::filesystem::path& library,
                                       const std::filesystem::path& files);

}  // namespace gloam::site
