// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "backend/backend.hpp"
#include "module/compile.hpp"
#include "numeric/numbers.hpp"

// The words of a row of inputs or outputs as the scalars of GLSL, a word for each.
namespace gloam::check {

using backend::Word;

void append_scalars(const shader::Type& type, std::vector<shader::Scalar>& scalars);
[[nodiscard]] std::vector<shader::Scalar> scalars_of(const shader::Type& type);

// A word as the number that it stands for.
[[nodiscard]] double number_at(shader::Scalar scalar, Word word);
// Of a word that is no float.
[[nodiscard]] double whole_number(shader::Scalar scalar, Word word);
[[nodiscard]] const numeric::FloatFormat& format_of(shader::Scalar scalar);
// The word of a float: the nearest value of its type; so many values above another one.
[[nodiscard]] Word float_word(shader::Scalar scalar, double value);
[[nodiscard]] Word stepped_float(shader::Scalar scalar, Word word, std::int64_t steps);
// Whether all words are equal; all NaNs of a type are.
[[nodiscard]] bool same_bits(std::span<const shader::Scalar> scalars, std::span<const Word> a,
                             std::span<const Word> b);
// "0.1 (0x3dcccccd)", "-3", "true".
[[nodiscard]] std::string text_of(shader::Scalar scalar, Word word);

}  // namespace gloam::check
