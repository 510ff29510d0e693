// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "shader/translate.hpp"

// What a person would write differently in the texts of SPIRV-Cross. The meaning stays.
namespace gloam::shader::internal {

// - Numbers with as few digits as name the same float: "1e+18f", not "999999984306749440.0f".
// - "x = a && (b);" where the text has "if (a) { x = b; } else { x = a; }", and the same for ||. HLSL before
// 2021
//   calculates b in any case: there only where b calls no function of the text and reads no array.
// - Specialization constants of HLSL by their names: a macro GLOAM_NAME for the value, not
//   SPIRV_CROSS_CONSTANT_ID_0.
// - In MSL, functions without linkage: "float f()", not "static inline __attribute__((always_inline)) float
// f()".
// - No samplers of images that are only fetched from.
[[nodiscard]] std::string tidy(const std::string& text, Target target);

}  // namespace gloam::shader::internal
