// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace gloam::catalogue {

// The description of an equation for people. All but the file stands in the comment of its GLSL function,
// which begins with one sentence:
//
//     // how far a pixel has converged (TSSAO-6): `conv = w / w_max` [TSSAO, eq 6].
//     float gloam_convergence(float weight, float weight_max) {
struct Description {
    std::string id;        // as in the paper or sheet, unique, no spaces: "TSSAO-5", "TSSAO-14-uniform"
    std::string function;  // in GLSL, and in C++ in gloam::reference
    std::string file;      // as in #include "gloam/..."
    std::string title;     // a few words
    std::string formula;   // plain text mathematics
    std::string source;    // paper, equation number
};

// The description of each equation of the shader library in a folder, by its ID. Throws std::runtime_error
// for a folder without the library, for a description without a function below it, and for an ID that stands
// twice.
[[nodiscard]] std::map<std::string, Description> descriptions(const std::filesystem::path& glsl);

}  // namespace gloam::catalogue
