// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shader/compile.hpp"

namespace gloam::shader::internal {

// A function of a module as SPIR-V keeps it: by the names of debug instructions and by its types. Directions
// of parameters are not part of it.
struct Signature {
    std::string name;  // as in GLSL, without the compiler's mark of the overload
    Type result;
    std::vector<Parameter> parameters;
    std::vector<std::size_t> calls;  // indices of the called functions, in the order of the module
};

// Every function of an unoptimised module, in the order of the module. An opaque type (sampler, image) has no
// text here: its Type::name is empty. Throws std::runtime_error when the words are no SPIR-V module.
[[nodiscard]] std::vector<Signature> signatures(const Spirv& module);

}  // namespace gloam::shader::internal
