// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace gloam::site {

// The files of the npm package by name: the effect in WebGL2 as a module, its types, and a pass for each
// engine. library: the folder with gloam/ and passes/. files: this folder (effect/, npm/, shaders/). licence:
// a file. Throws std::runtime_error for a file that cannot be read, and like module::pack().
[[nodiscard]] std::map<std::string, std::string> npm_package(const std::filesystem::path& library,
                                                             const std::filesystem::path& files,
                                                             const std::filesystem::path& licence);

}  // namespace gloam::site
