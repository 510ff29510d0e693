// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "backend/backend.hpp"
#include "shader/compile.hpp"
#include "shader/pack.hpp"

// Visits the members of a small aggregate in order, so that a plain struct needs no description of its own.
namespace gloam::check {
namespace detail {

struct AnyField {
    template <class T>
    operator T() const;  // never defined: used in unevaluated contexts only
};

template <class T, std::size_t... I>
constexpr bool initializable(std::index_sequence<I...>) {
    return requires { T{((void)I, AnyField{})...}; };
}

template <class T, std::size_t N = 9>
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

// Calls visit(member&) for each member of an aggregate of 1 to 9 members.
template <class T, class Visit>
void for_each_field(T& value, Visit&& visit) {
    using Value = std::remove_const_t<T>;
    static_assert(
        std::is_aggregate_v<Value>,
        "a parameter must be a scalar, a GLM vector or matrix, or a std::array or plain struct of those");
    constexpr std::size_t count = detail::field_count<Value>();
    static_assert(count > 0 && !detail::initializable<Value>(std::make_index_sequence<10>{}),
                  "a struct has 1 to 9 members");
    const auto all = [&visit](auto&... fields) { (visit(fields), ...); };
    if constexpr (count == 1) {
        auto& [a] = value;
        all(a);
    } else if constexpr (count == 2) {
        auto& [a, b] = value;
        all(a, b);
    } else if constexpr (count == 3) {
        auto& [a, b, c] = value;
        all(a, b, c);
    } else if constexpr (count == 4) {
        auto& [a, b, c, d] = value;
        all(a, b, c, d);
    } else if constexpr (count == 5) {
        auto& [a, b, c, d, e] = value;
        all(a, b, c, d, e);
    } else if constexpr (count == 6) {
        auto& [a, b, c, d, e, f] = value;
        all(a, b, c, d, e, f);
    } else if constexpr (count == 7) {
        auto& [a, b, c, d, e, f, g] = value;
        all(a, b, c, d, e, f, g);
    } else if constexpr (count == 8) {
        auto& [a, b, c, d, e, f, g, h] = value;
        all(a, b, c, d, e, f, g, h);
    } else {
        auto& [a, b, c, d, e, f, g, h, i] = value;
        all(a, b, c, d, e, f, g, h, i);
    }
}

// Conversion of C++ values to the 32-bit words of a kernel and back. A value is the sequence of its scalars:
// vectors by component, matrices by column, arrays by element, structures by member.

using backend::Word;

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

// Calls visit(scalar&) for every scalar of the value, in order.
template <class T, class Visit>
void visit_scalars(T& value, Visit&& visit) {
    using Value = std::remove_const_t<T>;
    if constexpr (ScalarValue<Value>) {
        visit(value);
    } else if constexpr (is_vector<Value> || is_matrix<Value>) {
        for (glm::length_t i = 0; i < Value::length(); ++i) visit_scalars(value[i], visit);
    } else if constexpr (is_array<Value>) {
        for (auto& element : value) visit_scalars(element, visit);
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
    } else if constexpr (is_array<T>) {
        Type type = type_of<typename T::value_type>();
        type.sizes.insert(type.sizes.begin(), static_cast<std::uint32_t>(T{}.size()));
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

// Marks a GLSL `out` parameter in a C++ signature: float(glm::vec2, Out<float>). A reference, float&, is
// `inout`.
template <class T>
struct Out {
    using type = T;
};

// A type of the signature with double in place of float, for references.
template <class T>
struct InDoubleOf {
    using type = T;
};
template <>
struct InDoubleOf<float> {
    using type = double;
};
template <glm::length_t N>
struct InDoubleOf<glm::vec<N, float>> {
    using type = glm::vec<N, double>;
};
template <glm::length_t C, glm::length_t R>
struct InDoubleOf<glm::mat<C, R, float>> {
    using type = glm::mat<C, R, double>;
};
template <class T, std::size_t N>
struct InDoubleOf<std::array<T, N>> {
    using type = std::array<typename InDoubleOf<T>::type, N>;
};
template <class T>
struct InDoubleOf<Quad<T>> {
    using type = Quad<typename InDoubleOf<T>::type>;
};
template <class T, std::uint32_t X, std::uint32_t Y, std::uint32_t Z>
struct InDoubleOf<Group<T, X, Y, Z>> {
    using type = Group<typename InDoubleOf<T>::type, X, Y, Z>;
};
template <class T>
using InDouble = typename InDoubleOf<T>::type;

// One parameter type of a C++ signature.
template <class P>
struct ParameterOf {
    using value = P;
    static constexpr auto direction = shader::Direction::in;
};
template <class T>
struct ParameterOf<T&> {
    using value = T;
    static constexpr auto direction = shader::Direction::inout;
};
template <class T>
struct ParameterOf<Out<T>> {
    using value = T;
    static constexpr auto direction = shader::Direction::out;
};
template <class P>
inline constexpr bool is_input = ParameterOf<P>::direction != shader::Direction::out;
template <class P>
inline constexpr bool is_output = ParameterOf<P>::direction != shader::Direction::in;

// A signature without its C++ types, for the wrapper, the domain and the judge.
struct Signature {
    shader::Type result;
    std::vector<shader::Parameter> parameters;
    // Of a function that needs other invocations: they run together, and the types above are arrays of the
    // function's own, with an element for each (together()).
    backend::Team team = {};

    [[nodiscard]] std::size_t input_words() const;
    // Number of words of the result (unless void) and of every out and inout parameter, in order.
    [[nodiscard]] std::size_t output_words() const;
    [[nodiscard]] std::vector<shader::Scalar> input_scalars() const;
    [[nodiscard]] std::vector<shader::Scalar> output_scalars() const;
    // Word counts of the output values (scalar, vector, matrix), one entry for each value.
    [[nodiscard]] std::vector<std::size_t> output_values() const;
};

// The function with variables at file scope as further parameters: those that it uses, of these names; and
// the images that it uses.
[[nodiscard]] shader::Function with_globals(shader::Function function, const shader::Excerpt& excerpt);

// Width and height of the images that a function under test loads and stores, of which each input has its
// own.
inline constexpr std::array<std::uint32_t, 2> image_sides{5, 4};

// The pixels of such an image: rows of values with the channels of the format, "rg32f".
[[nodiscard]] shader::Type pixels_of(std::string_view format);

// Whether each invocation of a team has its own value of a parameter. Samplers and uniforms are those of all.
[[nodiscard]] bool is_of_each(const shader::Parameter& parameter);

// A function as a team calls it: its result and its is_of_each() parameters are arrays with an element for
// each invocation.
[[nodiscard]] shader::Function together(shader::Function function, const backend::Team& team);

// "float f(vec2, out float)"; structures are written in full.
[[nodiscard]] std::string to_glsl(const Signature& signature, const std::string& name);

// The same for a compiled function; its structures are written in full, member by member.
[[nodiscard]] std::string to_glsl_with_layouts(shader::Function function);

// Whether a compiled function has this signature: the same types (structures by layout) and directions.
[[nodiscard]] bool matches(const Signature& signature, const shader::Function& function);

namespace detail {

template <class T>
struct Wrap {
    using type = std::tuple<T>;
};
template <>
struct Wrap<void> {
    using type = std::tuple<>;
};
template <bool Keep, class T>
using KeepIf = std::conditional_t<Keep, std::tuple<T>, std::tuple<>>;

}  // namespace detail

template <class Function>
struct SignatureOf;

template <class R, class... P>
struct SignatureOf<R(P...)> {
    using Result = R;
    // Values that a call takes and returns: tuples of plain types.
    using Inputs = decltype(std::tuple_cat(detail::KeepIf<is_input<P>, typename ParameterOf<P>::value>{}...));
    using Outputs = decltype(std::tuple_cat(
        typename detail::Wrap<R>::type{}, detail::KeepIf<is_output<P>, typename ParameterOf<P>::value>{}...));

    [[nodiscard]] static Signature describe() {
        const backend::Team team = team_of_all<R, typename ParameterOf<P>::value...>();
        const bool alone = team.kind == backend::Team::Kind::alone;
        return {.result = type_of<R>(),
                .parameters = {shader::Parameter{
                    .name = {},
                    .type = type_of<typename ParameterOf<P>::value>(),
                    .direction = ParameterOf<P>::direction,
                    .uniform = !alone && !is_of_team<typename ParameterOf<P>::value>}...},
                .team = team};
    }

  private:
    // Of the first type that has one; all that have one have the same.
    template <class... All>
    static constexpr backend::Team team_of_all() {
        backend::Team team;
        ((team = is_of_team<All> ? team_of<All> : team), ...);
        const auto fits = [&team](const backend::Team& other) {
            return other.kind == backend::Team::Kind::alone || other == team;
        };
        if (!(fits(team_of<All>) && ...))
            throw std::invalid_argument("a signature of quads and groups, or of two sizes");
        return team;
    }
};

}  // namespace gloam::check
