// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "check/scalars.hpp"
#include "shader/type.hpp"

namespace gloam::check {

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

    [[nodiscard]] std::size_t input_words() const;
    // Number of words of the result (unless void) and of every out and inout parameter, in order.
    [[nodiscard]] std::size_t output_words() const;
    [[nodiscard]] std::vector<shader::Scalar> input_scalars() const;
    [[nodiscard]] std::vector<shader::Scalar> output_scalars() const;
    // Word counts of the output values (scalar, vector, matrix), one entry for each value.
    [[nodiscard]] std::vector<std::size_t> output_values() const;
};

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
        return {.result = type_of<R>(),
                .parameters = {shader::Parameter{.name = {},
                                                 .type = type_of<typename ParameterOf<P>::value>(),
                                                 .direction = ParameterOf<P>::direction}...}};
    }
};

}  // namespace gloam::check
