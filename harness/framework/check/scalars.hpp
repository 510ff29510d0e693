// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "backend/backend.hpp"
#include "numeric/numbers.hpp"
#include "shader/compile.hpp"

// The words of a row of inputs or outputs as the scalars of GLSL.
namespace gloam::check {

using backend::Word;

// The words of a GLSL type in order, each as the scalar that begins there, or Scalar::upper.
void append_scalars(const shader::Type& type, std::vector<shader::Scalar>& scalars);
[[nodiscard]] std::vector<shader::Scalar> scalars_of(const shader::Type& type);

// Words of a scalar.
[[nodiscard]] constexpr std::size_t word_count(shader::Scalar scalar) {
    return shader::bits_of(scalar) == 64 ? 2 : 1;
}

// The bits of the scalar that begins at a word, and the same as a number. Of an integer of 64 bits each word
// is a number of its own, so that double represents both; the second word of a double is 0.
[[nodiscard]] std::uint64_t bits_at(shader::Scalar scalar, std::span<const Word> words);
void set_bits(shader::Scalar scalar, std::uint64_t bits, std::span<Word> words);
[[nodiscard]] double number_at(std::span<const shader::Scalar> scalars, std::span<const Word> words,
                               std::size_t word);
// Of a word that is no float.
[[nodiscard]] double whole_number(std::span<const shader::Scalar> scalars, Word bits, std::size_t word);
// Whether the word before it says all.
[[nodiscard]] bool is_rest_of_float(std::span<const shader::Scalar> scalars, std::size_t word);
// Of a float.
[[nodiscard]] double float_at(shader::Scalar scalar, std::span<const Word> words);
[[nodiscard]] const numeric::FloatFormat& format_of(shader::Scalar scalar);
// Sets a float to the nearest value of its type, or moves it by so many values.
void set_float(shader::Scalar scalar, double value, std::span<Word> words);
void append_float(shader::Scalar scalar, double value, std::vector<Word>& words);
void step_float(shader::Scalar scalar, std::int64_t steps, std::span<Word> words);
// Whether all words are equal; all NaNs of a type are.
[[nodiscard]] bool same_bits(std::span<const shader::Scalar> scalars, std::span<const Word> a,
                             std::span<const Word> b);
// "0.1 (0x3dcccccd)", "-3", "true".
[[nodiscard]] std::string text_at(shader::Scalar scalar, std::span<const Word> words);

}  // namespace gloam::check
