// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shader/compile.hpp"

namespace gloam::shader::internal {

// A function of a module as SPIR-V describes it: its name from the debug instructions, and its types.
// Directions of parameters are not included.
struct Signature {
    std::string name;  // as in GLSL, without the compiler's mark of the overload
    Type result;
    std::vector<Parameter> parameters;
    std::vector<std::size_t> calls;  // indices of the called functions, in the order of the module
};

// Every function of an unoptimised module, in the order of the module. For an opaque type (sampler, image)
// Type::name is empty. Throws std::runtime_error for words that are not a SPIR-V module.
[[nodiscard]] std::vector<Signature> signatures(const Spirv& module);

}  // namespace gloam::shader::internal
