// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "record/output.hpp"
#include "record/page.hpp"

// What runs in a browser. library: the folder with gloam/ and passes/. files: this folder (effect/, npm/,
// page/, shaders/). All throw std::runtime_error for a file that cannot be read, and like module::pack().
namespace gloam::site {

// The files of the npm package by name: the effect in WebGL2 as a module, its types, and a pass for each
// engine. licence: a file.
[[nodiscard]] std::map<std::string, std::string> npm_package(const std::filesystem::path& library,
                                                             const std::filesystem::path& files,
                                                             const std::filesystem::path& licence);

// Adds the live effect to a page: the class of the npm package in WebGL2 on scenes of gloam, with controls.
// Its scripts and scenes are written beside the page.
void add_live_effect(record::Page& page, record::OutputFolder& folder, const std::filesystem::path& library,
                     const std::filesystem::path& files);

// The classes of the effect in WebGL2 (effect/*.js): JavaScript with AmbientOcclusion and what it uses.
[[nodiscard]] std::string effect_classes(const std::filesystem::path& files);

// What AmbientOcclusion needs (effect/ambient-occlusion.js), as JSON: gloam's own presets, passes by name.
[[nodiscard]] std::string effect_json(const std::filesystem::path& library,
                                      const std::filesystem::path& files);

// The passes that draw a scene of the page and show it (page/picture.js), likewise.
[[nodiscard]] std::string picture_json(const std::filesystem::path& library,
                                       const std::filesystem::path& files);

}  // namespace gloam::site
