// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "shader/compile.hpp"

namespace gloam::shader {

// A resource that functions of the module use: a buffer, an image, a sampler, push constants.
struct Resource {
    std::string kind;   // "uniform buffer", "storage buffer", "image or sampler", "push constants"
    std::string name;   // of the variable; empty if the text gives none
    std::string block;  // of the buffer's type
};

// Every resource that a function of the module reads or writes, in the order of declaration. Throws
// std::runtime_error for words that are not a SPIR-V module.
[[nodiscard]] std::vector<Resource> used_resources(const Spirv& module);

}  // namespace gloam::shader
