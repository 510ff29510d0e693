// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "shader/internal/wgsl/statement.hpp"

namespace gloam::shader::internal::wgsl {

// `a operation b`, with brackets where WGSL needs them.
[[nodiscard]] Expression binary(const std::string& operation, const Expression& a, const Expression& b);
// `operation a`: "-", "!", "~".
[[nodiscard]] Expression unary(const std::string& operation, const Expression& a);
// `function(a, ...)`.
[[nodiscard]] Expression call(const std::string& function, std::vector<Expression> arguments);
// The expression as a part of one that binds its parts tightly: `a` of `a.x`.
[[nodiscard]] std::string primary(const Expression& a);
// An expression that is a name or a number as it stands.
[[nodiscard]] Expression plain(std::string text);
// A literal whose type is written: for functions and operators that have literals alone.
[[nodiscard]] Expression typed(Expression a);

// The arithmetic, logic and conversions that an instruction calculates from its operands. False where it is
// no such instruction.
class ModuleText;
[[nodiscard]] bool operation(ModuleText& text, const Instruction& instruction,
                             const std::vector<Expression>& operands, Expression& result);
// What an instruction of GLSL.std.450 calculates from its operands. False where there is no such instruction.
[[nodiscard]] bool extended_operation(ModuleText& text, const Instruction& instruction,
                                      const std::vector<Expression>& operands, Expression& result);

}  // namespace gloam::shader::internal::wgsl
