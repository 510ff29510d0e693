// SPDX-License-Identifier: MIT
#pragma once

#include "shader/compile.hpp"
#include "shader/language.hpp"

// How far the precision rules of OpenGL agree with those of Vulkan, by which the interpreter judges
// (docs/opengl-and-browsers.md).
namespace gloam::check::internal {

// Whether the rules of this version of GLSL can be asked: GLSL 4.50 and GLSL ES 3.20, whose section 4.7.1 has
// the same table as Vulkan, and which know `precise`.
[[nodiscard]] bool has_precision_rules(shader::Language language);

// Whether the module calls a built-in whose precision section 4.7.1 leaves undefined: a trigonometric or
// hyperbolic function, determinant, inverse.
[[nodiscard]] bool calls_undefined_precision(const shader::Spirv& module);

}  // namespace gloam::check::internal
