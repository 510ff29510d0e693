// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace gloam::site {

struct NpmOptions {
    std::filesystem::path library;  // with gloam/ and passes/
    std::filesystem::path files;    // with effect/, npm/ and shaders/
    std::filesystem::path licence;
    std::string version;  // of the package
};

// The files of the npm package by name: the effect in WebGL2 as a module, its types, and a pass for each
// engine. Throws std::runtime_error for a file that cannot be read, and like shader::pack().
[[nodiscard]] std::map<std::string, std::string> npm_package(const NpmOptions& options);

}  // namespace gloam::site
