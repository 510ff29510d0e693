// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/text.hpp"
#include "source/tokens.hpp"

namespace gloam::shader::internal {

// A parameter as it is written, with the parts that SPIR-V does not keep.
struct DeclaredParameter {
    Direction direction = Direction::in;
    std::string type;  // without qualifiers, with every array size: "float[2][3]"
    std::string name;  // may be empty
};

// A function definition or prototype at global scope.
struct Declaration {
    std::string name;
    std::string result;  // as written, qualifiers included
    std::string head;    // "float f ( vec2 uv )"
    std::vector<DeclaredParameter> parameters;
    bool defined = false;  // a body follows
    std::size_t list = 0;  // the token of the statement behind the '(' of its parameters
    std::size_t body = 0;  // and behind the ')'
};

// The function that a statement declares: its parameters follow a type and a name.
[[nodiscard]] std::optional<Declaration> declaration_of(Tokens statement);

// The functions that a GLSL text defines and declares, in its order. The text is preprocessed: lines that
// begin with # are ignored.
[[nodiscard]] std::vector<Declaration> declarations(std::string preprocessed);

// One declaration for each function: of those that are defined first, then of those that are only declared.
[[nodiscard]] std::vector<Declaration> each_once(std::vector<Declaration> functions);

// The text with a body for each function without one, and with an empty main if there is none, because SPIR-V
// contains complete programs only.
[[nodiscard]] std::string completed(std::string text, const std::vector<Declaration>& functions);

}  // namespace gloam::shader::internal
