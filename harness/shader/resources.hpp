// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "shader/compile.hpp"

namespace gloam::shader {

// Something outside the module that its functions use: a buffer, an image, a sampler, push constants.
struct Resource {
    std::string kind;   // "uniform buffer", "storage buffer", "image or sampler", "push constants"
    std::string name;   // of the variable; empty where the text gives none
    std::string block;  // of the buffer's type
};

// Every one that a function of the module reads or writes, in the order of their declaration. Throws
// std::runtime_error when the words are no SPIR-V module.
[[nodiscard]] std::vector<Resource> used_resources(const Spirv& module);

}  // namespace gloam::shader
