// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shader/compile.hpp"

namespace gloam::shader::internal {

using Tokens = std::span<const std::string>;

// Words (names with what follows behind a '.', keywords, numbers) and single characters of a text without
// comments; lines that begin with # are passed over.
[[nodiscard]] std::vector<std::string> tokens_of(std::string_view text);

// The index behind the bracket that closes the one at `open`; the end if there is none.
[[nodiscard]] std::size_t behind_bracket(Tokens tokens, std::size_t open);

[[nodiscard]] bool contains(Tokens tokens, std::string_view word);

// Where a declaration begins: behind macros that are called without a ';', as in "INFO(name) float f(float
// x)".
[[nodiscard]] std::size_t behind_macro_lines(Tokens statement);

// The first parenthesis of a statement that starts a list of parameters: it follows a type and a name.
[[nodiscard]] std::optional<std::size_t> parameter_list(Tokens statement);

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

// A function of a module as SPIR-V describes it: its name from the debug instructions, and its types.
// Directions of parameters are not included.
struct Signature {
    std::string name;  // as in GLSL, without the compiler's mark of the overload
    Type result;
    std::vector<Parameter> parameters;
    std::vector<std::size_t> calls;  // indices of the called functions, in the order of the module
    // Private variables of the module that it uses, itself or by what it calls, in the order of use.
    std::vector<Parameter> globals;
    std::string other_number = {};  // see Function
};

// Every function of an unoptimised module, in the order of the module. For an opaque type (sampler, image)
// Type::name is empty. Throws std::runtime_error for words that are not a SPIR-V module.
[[nodiscard]] std::vector<Signature> signatures(const Spirv& module);

}  // namespace gloam::shader::internal
