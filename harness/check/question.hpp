// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "check/budget.hpp"
#include "check/domain.hpp"
#include "check/image.hpp"
#include "check/signature.hpp"
#include "numeric/random.hpp"

namespace gloam::check {

// Images for one run of a function that reads images; a check runs every scenario with its share of the
// inputs.
struct ImageScenario {
    std::string name;  // "3 x 3", "all background"
    glm::ivec2 size{1};
    std::function<ImageSet(glm::ivec2 size, numeric::Random& random)> make;
};

// A reference without its C++ types: input words in, one double for each output word out. If a question has
// none, the module interpreted in double replaces it.
using Reference =
    std::function<void(const ImageSet& images, std::span<const Word> inputs, std::vector<double>& outputs)>;

// The range in which every output except a bool must be, for every input. NaN is never inside.
struct Codomain {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
};

// The check of a function: the source of its inputs, its expected results and their accuracy.
struct Question {
    std::string name;  // for reports: an ID of the catalogue; empty: the function's name
    std::string file;
    std::string function;
    Signature signature;
    Domain domain;
    Reference reference;  // empty: the rules judge, and the module in double is the reference
                          // in double
    Budget budget;
    Codomain codomain;
    // Inputs for which the budget is promised; empty: all. For other inputs, for example after overflow, only
    // the codomain and the documented results for zero, infinity and NaN are judged.
    std::function<bool(std::span<const Word>)> promised;
    // Whether every input of the domain has a defined result. If not, an input for which the function reads
    // outside an array, for example, is not judged; otherwise it is a failure.
    bool defined = true;
    std::vector<ImageScenario> scenarios;  // empty: the function reads no image
    bool only_rules = false;               // it documents no accuracy: judged by the rules in every variant
};

namespace detail {

template <class T>
void append(const T& value, std::vector<double>& outputs) {
    visit_scalars(value, [&outputs](const auto& scalar) { outputs.push_back(static_cast<double>(scalar)); });
}

// Calls a reference, with the images as first argument if it takes them.
template <class Callable, class... Values>
decltype(auto) call(const Callable& callable, const ImageSet& images, Values&... values) {
    if constexpr (std::is_invocable_v<const Callable&, const ImageSet&, Values&...>) {
        return callable(images, values...);
    } else {
        return callable(values...);
    }
}

template <class Function>
struct ReferenceOf;

template <class R, class... P>
struct ReferenceOf<R(P...)> {
    using Arguments = std::tuple<InDouble<typename ParameterOf<P>::value>...>;
    static constexpr auto indices = std::index_sequence_for<P...>{};

    template <std::size_t... I>
    static Arguments read([[maybe_unused]] std::span<const Word> words, std::index_sequence<I...>) {
        Arguments arguments{};
        ((is_input<P> ? void(std::get<I>(arguments) = take_words<std::tuple_element_t<I, Arguments>>(words))
                      : void()),
         ...);
        return arguments;
    }

    template <std::size_t... I>
    static void append_outputs(const Arguments& arguments, std::vector<double>& outputs,
                               std::index_sequence<I...>) {
        ((is_output<P> ? append(std::get<I>(arguments), outputs) : void()), ...);
    }

    // Appends the result, then every out and inout parameter.
    template <class Callable>
    static void run(const Callable& callable, const ImageSet& images, std::span<const Word> words,
                    std::vector<double>& outputs) {
        Arguments arguments = read(words, indices);
        const auto with = [&](auto&... values) -> decltype(auto) {
            return call(callable, images, values...);
        };
        if constexpr (std::is_void_v<R>) {
            std::apply(with, arguments);
        } else {
            append(static_cast<InDouble<R>>(std::apply(with, arguments)), outputs);
        }
        append_outputs(arguments, outputs, indices);
    }
};

}  // namespace detail

// Makes a reference from a callable with the types of the signature, with double in place of float: (double,
// glm::dvec3) for float(float, glm::vec3). Out and inout parameters are references. The images (const
// ImageSet&) can be the first argument.
template <class Function, class Callable>
[[nodiscard]] Reference make_reference(Callable callable) {
    return [callable](const ImageSet& images, std::span<const Word> words, std::vector<double>& outputs) {
        outputs.clear();
        detail::ReferenceOf<Function>::run(callable, images, words, outputs);
    };
}

// Makes a `promised` test from a predicate on typed inputs. It is called with the exact values of in and
// inout parameters.
template <class Function, class Predicate>
[[nodiscard]] std::function<bool(std::span<const Word>)> make_predicate(Predicate predicate) {
    return [predicate](std::span<const Word> words) {
        using Inputs = typename SignatureOf<Function>::Inputs;
        Inputs inputs{};
        std::apply(
            [&words](auto&... value) {
                ((value = take_words<std::remove_cvref_t<decltype(value)>>(words)), ...);
            },
            inputs);
        return std::apply(predicate, inputs);
    };
}

}  // namespace gloam::check
