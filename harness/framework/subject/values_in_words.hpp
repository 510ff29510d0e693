// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "backend/backend.hpp"
#include "module/compile.hpp"

// Visits the members of a small aggregate in order, so that a plain struct needs no description of its own.
namespace gloam::subject {
namespace detail {

struct AnyField {
    template <class T>
    operator T() const;  // never defined: used in unevaluated contexts only
};

template <class T, std::size_t... I>
constexpr bool initializable(std::index_sequence<I...>) {
    return requires { T{((void)I, AnyField{})...}; };
}

template <class T, std::size_t N = 10>
constexpr std::size_t field_count() {
    if constexpr (N == 0) {
        return 0;
    } else if constexpr (initializable<T>(std::make_index_sequence<N>{})) {
        return N;
    } else {
        return field_count<T, N - 1>();
    }
}

}  // namespace detail

// Calls visit(member&) for each member of an aggregate of 1 to 10 members.
template <class T, class Visit>
void for_each_field(T& value, Visit&& visit) {
    using Value = std::remove_const_t<T>;
    static_assert(
        std::is_aggregate_v<Value>,
        "a parameter must be a scalar, a GLM vector or matrix, or a std::array or plain struct of those");
    constexpr std::size_t count = detail::field_count<Value>();
    static_assert(count > 0 && !detail::initializable<Value>(std::make_index_sequence<11>{}),
                  "a struct has 1 to 10 members");
    const auto all = [&visit](auto&... fields) { (visit(fields), ...); };
#define GLOAM_FIELDS(number, ...)    \
    if constexpr (count == number) { \
        auto& [__VA_ARGS__] = value; \
        all(__VA_ARGS__);            \
    }
    GLOAM_FIELDS(1, a)
    GLOAM_FIELDS(2, a, b)
    GLOAM_FIELDS(3, a, b, c)
    GLOAM_FIELDS(4, a, b, c, d)
    GLOAM_FIELDS(5, a, b, c, d, e)
    GLOAM_FIELDS(6, a, b, c, d, e, f)
    GLOAM_FIELDS(7, a, b, c, d, e, f, g)
    GLOAM_FIELDS(8, a, b, c, d, e, f, g, h)
    GLOAM_FIELDS(9, a, b, c, d, e, f, g, h, i)
    GLOAM_FIELDS(10, a, b, c, d, e, f, g, h, i, j)
#undef GLOAM_FIELDS
}

// Conversion of C++ values to the 32-bit words of a kernel and back. A value is the sequence of its scalars:
// vectors by component, matrices by column, arrays by element, structures by member.

using backend::Word;

// A C++ type for a number that is a float in the shader.
template <class T>
concept FloatValue = std::same_as<T, float> || std::same_as<T, double>;

// The float16_t of the shader; its word is that of the float of its value.
struct Float16 {
    float value;  // 0 where it is value-initialized; trivial, so that GLM's vectors of it are, too
    constexpr Float16() = default;
    constexpr Float16(float x) : value(x) {}
    constexpr operator float() const { return value; }
};

template <class T>
concept ScalarValue = FloatValue<T> || std::same_as<T, Float16> || std::same_as<T, int> ||
                      std::same_as<T, unsigned> || std::same_as<T, bool>;

template <class T>
inline constexpr bool is_vector = false;
template <glm::length_t N, class T>
inline constexpr bool is_vector<glm::vec<N, T>> = true;
template <class T>
inline constexpr bool is_matrix = false;
template <glm::length_t C, glm::length_t R, class T>
inline constexpr bool is_matrix<glm::mat<C, R, T>> = true;
// Values of the invocations that run a function together. In a signature they stand for the function's own T:
// a fragment quad, (0, 0), (1, 0), (0, 1), (1, 1); or a work group in the order of gl_LocalInvocationIndex.
// Other parameters have one value for all.
template <class T>
struct Quad : std::array<T, 4> {};
template <class T, std::uint32_t X, std::uint32_t Y = 1, std::uint32_t Z = 1>
struct Group : std::array<T, std::size_t{X} * Y * Z> {};

template <class T>
inline constexpr backend::Team team_of{};
template <class T>
inline constexpr backend::Team team_of<Quad<T>> = backend::quad_team;
template <class T, std::uint32_t X, std::uint32_t Y, std::uint32_t Z>
inline constexpr backend::Team team_of<Group<T, X, Y, Z>>{.kind = backend::Team::Kind::group,
                                                          .size = {X, Y, Z}};
template <class T>
inline constexpr bool is_of_team = team_of<T>.kind != backend::Team::Kind::alone;

template <class T>
inline constexpr bool is_array = is_of_team<T>;
template <class T, std::size_t N>
inline constexpr bool is_array<std::array<T, N>> = true;

template <class T>
inline constexpr bool is_tuple = false;
template <class... T>
inline constexpr bool is_tuple<std::tuple<T...>> = true;

// Calls visit(scalar&) for every scalar of a value, or of a tuple of values, in order.
template <class T, class Visit>
void visit_scalars(T& value, Visit&& visit) {
    using Value = std::remove_const_t<T>;
    if constexpr (ScalarValue<Value>) {
        visit(value);
    } else if constexpr (is_vector<Value> || is_matrix<Value>) {
        for (glm::length_t i = 0; i < Value::length(); ++i) visit_scalars(value[i], visit);
    } else if constexpr (is_array<Value>) {
        for (auto& element : value) visit_scalars(element, visit);
    } else if constexpr (is_tuple<Value>) {
        std::apply([&visit](auto&... all) { (visit_scalars(all, visit), ...); }, value);
    } else {
        for_each_field(value, [&visit](auto& field) { visit_scalars(field, visit); });
    }
}

// The type of a C++ number in the shader.
template <ScalarValue T>
[[nodiscard]] constexpr module::Scalar scalar_of() {
    using enum module::Scalar;
    if (FloatValue<T>) return float_;
    if (std::same_as<T, Float16>) return float16_;
    if (std::same_as<T, bool>) return bool_;
    return std::same_as<T, int> ? int_ : uint_;
}

// The GLSL type of a C++ type. double means float, since references calculate with more precision than the
// shader.
template <class T>
[[nodiscard]] module::Type type_of() {
    if constexpr (std::same_as<T, void>) {
        return {.scalar = module::Scalar::void_};
    } else if constexpr (ScalarValue<T>) {
        return {.scalar = scalar_of<T>()};
    } else if constexpr (is_vector<T>) {
        return {.scalar = scalar_of<typename T::value_type>(), .rows = T::length()};
    } else if constexpr (is_matrix<T>) {
        return {.scalar = scalar_of<typename T::value_type>(),
                .columns = T::length(),
                .rows = T::col_type::length()};
    } else if constexpr (is_array<T>) {
        module::Type type = type_of<typename T::value_type>();
        type.sizes.insert(type.sizes.begin(), static_cast<std::uint32_t>(T{}.size()));
        return type;
    } else {
        module::Type type{.scalar = module::Scalar::structure, .name = "struct"};
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
    if constexpr (FloatValue<T> || std::same_as<T, Float16>) {
        return std::bit_cast<Word>(static_cast<float>(scalar));
    } else {
        return static_cast<Word>(scalar);
    }
}

template <ScalarValue T>
[[nodiscard]] T from_word(Word word) {
    if constexpr (FloatValue<T> || std::same_as<T, Float16>) {
        return static_cast<T>(std::bit_cast<float>(word));
    } else {
        return static_cast<T>(word);
    }
}

template <class T>
void append_words(const T& value, std::vector<Word>& words) {
    visit_scalars(value, [&words](const auto& scalar) { words.push_back(to_word(scalar)); });
}

// Appends the numbers of all its scalars.
template <class T>
void append_numbers(const T& value, std::vector<double>& numbers) {
    visit_scalars(value, [&numbers](const auto& scalar) { numbers.push_back(static_cast<double>(scalar)); });
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

}  // namespace gloam::subject
