// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "backend/backend.hpp"
#include "module/compile.hpp"
#include "module/texts.hpp"
#include "numeric/numbers.hpp"
#include "subject/values_in_words.hpp"

namespace gloam::subject {

// Calls visit() with the type of each scalar, vector and matrix in a value, in order; samplers are none.
void for_each_value(const module::Type& type, const std::function<void(const module::Type&)>& visit);
// The scalars of a value, a word for each.
[[nodiscard]] std::vector<module::Scalar> scalars_of(const module::Type& type);

// A word as the number that it stands for.
[[nodiscard]] double number_at(module::Scalar scalar, Word word);
// Of a word that is no float.
[[nodiscard]] double whole_number(module::Scalar scalar, Word word);
[[nodiscard]] const numeric::FloatFormat& format_of(module::Scalar scalar);
// The word of a float: the nearest value of its type; so many values above another one.
[[nodiscard]] Word float_word(module::Scalar scalar, double value);
[[nodiscard]] Word stepped_float(module::Scalar scalar, Word word, std::int64_t steps);
// Whether all words are equal; all NaNs of a type are.
[[nodiscard]] bool same_bits(std::span<const module::Scalar> scalars, std::span<const Word> a,
                             std::span<const Word> b);
// "0.1 (0x3dcccccd)", "-3", "true".
[[nodiscard]] std::string text_of(module::Scalar scalar, Word word);

// Marks a GLSL `out` parameter in a C++ signature: float(glm::vec2, Out<float>). A reference, float&, is
// `inout`.
template <class T>
struct Out {
    using type = T;
};

// A type with Float in place of float, double and Float16: references calculate in double.
template <class T, class Float>
struct InFloatsOf {
    using type = std::conditional_t<FloatValue<T> || std::same_as<T, Float16>, Float, T>;
};
template <glm::length_t N, class T, class Float>
struct InFloatsOf<glm::vec<N, T>, Float> {
    using type = glm::vec<N, typename InFloatsOf<T, Float>::type>;
};
template <glm::length_t C, glm::length_t R, class T, class Float>
struct InFloatsOf<glm::mat<C, R, T>, Float> {
    using type = glm::mat<C, R, typename InFloatsOf<T, Float>::type>;
};
template <class T, std::size_t N, class Float>
struct InFloatsOf<std::array<T, N>, Float> {
    using type = std::array<typename InFloatsOf<T, Float>::type, N>;
};
template <class T, class Float>
struct InFloatsOf<Quad<T>, Float> {
    using type = Quad<typename InFloatsOf<T, Float>::type>;
};
template <class T, std::uint32_t X, std::uint32_t Y, std::uint32_t Z, class Float>
struct InFloatsOf<Group<T, X, Y, Z>, Float> {
    using type = Group<typename InFloatsOf<T, Float>::type, X, Y, Z>;
};
template <class T>
using InDouble = typename InFloatsOf<T, double>::type;
template <class T>
using InFloat = typename InFloatsOf<T, float>::type;

// One parameter type of a C++ signature.
template <class P>
struct ParameterOf {
    using value = P;
    static constexpr auto direction = source::Direction::in;
};
template <class T>
struct ParameterOf<T&> {
    using value = T;
    static constexpr auto direction = source::Direction::inout;
};
template <class T>
struct ParameterOf<Out<T>> {
    using value = T;
    static constexpr auto direction = source::Direction::out;
};
template <class P>
inline constexpr bool is_input = ParameterOf<P>::direction != source::Direction::out;
template <class P>
inline constexpr bool is_output = ParameterOf<P>::direction != source::Direction::in;

// An in or inout parameter, and where its words stand in an input.
struct InputSlot {
    const module::Parameter* parameter;
    std::size_t first;  // word
    std::size_t count;  // words; 0 of a sampler
};

// A signature without its C++ types, for the wrapper, the domain and the judge.
struct Signature {
    module::Type result;
    std::vector<module::Parameter> parameters;
    // Of a function that needs other invocations: they run together, and the types above are arrays of the
    // function's own, with an element for each (together()).
    backend::Team team = {};

    // In the order of the parameters, which it refers to.
    [[nodiscard]] std::vector<InputSlot> inputs() const;
    [[nodiscard]] std::size_t input_words() const;
    // Number of words of the result (unless void) and of every out and inout parameter, in order.
    [[nodiscard]] std::size_t output_words() const;
    [[nodiscard]] std::vector<module::Scalar> input_scalars() const;
    [[nodiscard]] std::vector<module::Scalar> output_scalars() const;
    // Word counts of the output values (scalar, vector, matrix), one entry for each value.
    [[nodiscard]] std::vector<std::size_t> output_values() const;
};

// The function with variables at file scope as further parameters: those that it uses, of these names; and
// the images that it uses.
[[nodiscard]] module::Function with_globals(module::Function function, const source::Excerpt& excerpt);

// Width and height of the images that a function under test loads and stores, of which each input has its
// own.
inline constexpr std::array<std::uint32_t, 2> image_sides{5, 4};

// The pixels of such an image: rows of values with the channels of the format, "rg32f".
[[nodiscard]] module::Type pixels_of(std::string_view format);

// Whether each invocation of a team has its own value of a parameter. Samplers and uniforms are those of all.
[[nodiscard]] bool is_of_each(const module::Parameter& parameter);

// A function as a team calls it: its result and its is_of_each() parameters are arrays with an element for
// each invocation.
[[nodiscard]] module::Function together(module::Function function, const backend::Team& team);

// "float f(vec2, out float)"; structures are written in full.
[[nodiscard]] std::string to_glsl(const Signature& signature, const std::string& name);

namespace detail {

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
    using Outputs =
        decltype(std::tuple_cat(detail::KeepIf<!std::is_void_v<R>, R>{},
                                detail::KeepIf<is_output<P>, typename ParameterOf<P>::value>{}...));

    [[nodiscard]] static Signature describe() {
        const backend::Team team = team_of_all<R, typename ParameterOf<P>::value...>();
        const bool alone = team.kind == backend::Team::Kind::alone;
        return {.result = type_of<R>(),
                .parameters = {module::Parameter{
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

}  // namespace gloam::subject
