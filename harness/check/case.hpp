// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "check/judge.hpp"
#include "check/kernel_core.hpp"
#include "check/lab.hpp"
#include "numeric/random.hpp"

namespace gloam::check {

// Images for one run of a function that reads some; a check runs every scenario with its share of the inputs.
struct ImageScenario {
    std::string name;  // "3 x 3", "all background"
    glm::ivec2 size{1};
    std::function<ImageSet(glm::ivec2 size, numeric::Random& random)> make;
};

// Everything that a check needs: a function, where its inputs come from, what it should return and how
// closely.
struct Case {
    std::string file;
    std::string function;
    Signature signature;
    Domain domain;
    Reference reference;  // empty: the function is judged by the rules, and measured against itself in double
    Budget budget;
    Codomain codomain;
    std::function<bool(std::span<const Word>)> promised;  // see Rules
    bool only_rules = false;  // documents no accuracy of its own: judged by the rules however it is compiled
    std::vector<ImageScenario> scenarios;  // empty: the function reads no image
};

namespace detail {

template <class T>
void append(const T& value, std::vector<double>& outputs) {
    visit_scalars(value, [&outputs](const auto& scalar) { outputs.push_back(static_cast<double>(scalar)); });
}

// Calls a reference: with the images first, or with the arguments alone.
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

// A reference from anything callable with the types of the signature, with double in the place of float:
// (double, glm::dvec3) for float(float, glm::vec3); out and inout parameters as references; optionally the
// images first (const ImageSet&).
template <class Function, class Callable>
[[nodiscard]] Reference make_reference(Callable callable) {
    return [callable](const ImageSet& images, std::span<const Word> words, std::vector<double>& outputs) {
        outputs.clear();
        detail::ReferenceOf<Function>::run(callable, images, words, outputs);
    };
}

// A test of typed inputs as a `promised` rule: called with the exact values of in and inout parameters.
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

struct RunOptions {
    std::size_t inputs = 65'536;
    std::uint64_t seed = 1;
};

// What results of shaders compiled in a variant are held against: those of strict and relaxed ones the rules
// alone, all others the documented budget and the rules. A case with only_rules or without a reference is
// never held against a budget.
[[nodiscard]] Verdict verdict_of(const shader::Variant& variant, const Case& check_case);

// What a check found of one function.
struct Result {
    std::string file;
    std::string function;
    Signature signature;
    Budget budget;
    Verdict verdict = Verdict::budget;
    Census census;
    std::optional<ImageFault> fault;  // an access outside an image
    // Of inputs given as constants of the shader: those whose results have other bits than the same shader
    // gives for the same inputs read from memory (one NaN is as good as another).
    std::size_t differs = 0;

    [[nodiscard]] bool passed() const { return census.outside() == 0 && !fault; }
};

// Compiles the function, evaluates the inputs and judges every output. Throws as Lab::kernel and
// KernelCore::run do.
[[nodiscard]] Result run(const Lab& lab, const Case& check_case, const RunOptions& options = {});

// The whole check of a function against a reference in one call.
template <class Function, class Callable>
[[nodiscard]] Result compare(const Lab& lab, const std::string& file, const std::string& function,
                             Callable reference, const Domain& domain, const Budget& budget = {},
                             const RunOptions& options = {}) {
    return run(lab,
               Case{.file = file,
                    .function = function,
                    .signature = SignatureOf<Function>::describe(),
                    .domain = domain,
                    .reference = make_reference<Function>(std::move(reference)),
                    .budget = budget},
               options);
}

// Whether the results of a function are ones that Vulkan's precision rules permit the module that the driver
// was given, with no reference and no tolerance of anybody's choice.
template <class Function>
[[nodiscard]] Result check_rules(const Lab& lab, const std::string& file, const std::string& function,
                                 const Domain& domain, const RunOptions& options = {}) {
    return run(lab,
               Case{.file = file,
                    .function = function,
                    .signature = SignatureOf<Function>::describe(),
                    .domain = domain},
               options);
}

}  // namespace gloam::check
