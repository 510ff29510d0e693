// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "check/fields.hpp"
#include "shader/type.hpp"

// Conversion of C++ values to the 32-bit words of a kernel and back. A value is the sequence of its scalars:
// vectors by component, matrices by column, structures by member.
namespace gloam::check {

using Word = std::uint32_t;

// A C++ type for a number that is a float in the shader.
template <class T>
concept FloatValue = std::same_as<T, float> || std::same_as<T, double>;

template <class T>
concept ScalarValue =
    FloatValue<T> || std::same_as<T, int> || std::same_as<T, unsigned> || std::same_as<T, bool>;

template <class T>
inline constexpr bool is_vector = false;
template <glm::length_t N, class T>
inline constexpr bool is_vector<glm::vec<N, T>> = true;
template <class T>
inline constexpr bool is_matrix = false;
template <glm::length_t C, glm::length_t R, class T>
inline constexpr bool is_matrix<glm::mat<C, R, T>> = true;

// Calls visit(scalar&) for every scalar of the value, in order.
template <class T, class Visit>
void visit_scalars(T& value, Visit&& visit) {
    using Value = std::remove_const_t<T>;
    if constexpr (ScalarValue<Value>) {
        visit(value);
    } else if constexpr (is_vector<Value> || is_matrix<Value>) {
        for (glm::length_t i = 0; i < Value::length(); ++i) visit_scalars(value[i], visit);
    } else {
        for_each_field(value, [&visit](auto& field) { visit_scalars(field, visit); });
    }
}

template <class T>
[[nodiscard]] std::size_t scalar_count() {
    T value{};
    std::size_t count = 0;
    visit_scalars(value, [&count](auto&) { ++count; });
    return count;
}

// The GLSL type of a C++ type. double means float, since references calculate with more precision than the
// shader.
template <class T>
[[nodiscard]] shader::Type type_of() {
    using shader::Scalar;
    using shader::Type;
    if constexpr (std::same_as<T, void>) {
        return Type{.scalar = Scalar::void_};
    } else if constexpr (FloatValue<T>) {
        return Type{.scalar = Scalar::float_};
    } else if constexpr (std::same_as<T, int>) {
        return Type{.scalar = Scalar::int_};
    } else if constexpr (std::same_as<T, unsigned>) {
        return Type{.scalar = Scalar::uint_};
    } else if constexpr (std::same_as<T, bool>) {
        return Type{.scalar = Scalar::bool_};
    } else if constexpr (is_vector<T>) {
        Type type = type_of<typename T::value_type>();
        type.rows = T::length();
        return type;
    } else if constexpr (is_matrix<T>) {
        Type type = type_of<typename T::value_type>();
        type.columns = T::length();
        type.rows = T::col_type::length();
        return type;
    } else {
        Type type{.scalar = Scalar::structure, .name = "struct"};
        T value{};
        for_each_field(value, [&type](auto& field) {
            // C++ does not expose the names of members; where names matter, those of GLSL are used.
            type.members.push_back({.name = "member" + std::to_string(type.members.size()),
                                    .type = type_of<std::remove_cvref_t<decltype(field)>>()});
        });
        return type;
    }
}

// Conversion of one scalar to and from its word. bool is 0 or 1; double is rounded to float.
template <ScalarValue T>
[[nodiscard]] Word to_word(T scalar) {
    if constexpr (std::same_as<T, bool>) {
        return scalar ? 1U : 0U;
    } else if constexpr (std::same_as<T, double>) {
        return std::bit_cast<Word>(static_cast<float>(scalar));
    } else {
        return std::bit_cast<Word>(scalar);
    }
}

template <ScalarValue T>
[[nodiscard]] T from_word(Word word) {
    if constexpr (std::same_as<T, bool>) {
        return word != 0U;
    } else if constexpr (std::same_as<T, double>) {
        return static_cast<double>(std::bit_cast<float>(word));
    } else {
        return std::bit_cast<T>(word);
    }
}

template <class T>
void append_words(const T& value, std::vector<Word>& words) {
    visit_scalars(value, [&words](const auto& scalar) { words.push_back(to_word(scalar)); });
}

// Reads a value from the first words and returns it; `words` then begins behind it.
template <class T>
[[nodiscard]] T take_words(std::span<const Word>& words) {
    T value{};
    visit_scalars(value, [&words](auto& scalar) {
        scalar = from_word<std::remove_cvref_t<decltype(scalar)>>(words.front());
        words = words.subspan(1);
    });
    return value;
}

// The scalars of a GLSL type in order.
void append_scalars(const shader::Type& type, std::vector<shader::Scalar>& scalars);
[[nodiscard]] std::vector<shader::Scalar> scalars_of(const shader::Type& type);

}  // namespace gloam::check
