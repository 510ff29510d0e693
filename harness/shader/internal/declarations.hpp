// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shader/type.hpp"

namespace gloam::shader::internal {

// A parameter as it is written, with the parts that SPIR-V does not keep.
struct DeclaredParameter {
    Direction direction = Direction::in;
    std::string type;  // without qualifiers, with every array size: "float[2][3]"
};

// A function definition or prototype at global scope.
struct Declaration {
    std::string name;
    std::string result;  // as written, qualifiers included
    std::string head;    // "float f ( vec2 uv )"
    std::vector<DeclaredParameter> parameters;
    bool defined = false;  // a body follows
};

// The functions that a GLSL text defines and declares, in the order of the text. The text is preprocessed: no
// comments, no macros; lines that begin with # are ignored. It must be valid GLSL.
[[nodiscard]] std::vector<Declaration> declarations(std::string_view preprocessed);

// The text with a body for each function without one, and with an empty main if there is none, because SPIR-V
// contains complete programs only.
[[nodiscard]] std::string completed(std::string text, const std::vector<Declaration>& functions);

// Whether both have the same name and parameter types, and so declare one function.
[[nodiscard]] bool declare_the_same(const Declaration& a, const Declaration& b);

}  // namespace gloam::shader::internal
