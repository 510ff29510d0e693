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
#include "numeric/paths.hpp"
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
    Reference reference;
    Budget budget;
    Codomain codomain;
    std::function<bool(std::span<const Word>)> promised;  // see Rules
    Permission permitted;                                 // empty: the function cannot be judged by the rules
    bool only_rules = false;  // documents no accuracy of its own: judged by the rules however it is compiled
    std::vector<ImageScenario> scenarios;  // empty: the function reads no image
};

namespace detail {

template <class T, class Number>
void append(const T& value, std::vector<Number>& outputs) {
    visit_scalars(value, [&outputs](const auto& scalar) {
        if constexpr (std::same_as<Number, double>) {
            outputs.push_back(static_cast<double>(scalar));
        } else if constexpr (std::same_as<std::remove_cvref_t<decltype(scalar)>, numeric::Interval>) {
            outputs.push_back(scalar.bounds());
        } else {
            outputs.push_back(Number::point(static_cast<double>(scalar)));
        }
    });
}

// Calls a reference: with a tag of the number type first, with the images first, or with the arguments alone.
template <class Number>
struct Call {
    const ImageSet& images;

    template <class Callable, class... Values>
    decltype(auto) operator()(const Callable& callable, Values&... values) const {
        if constexpr (std::is_invocable_v<const Callable&, std::type_identity<Number>, Values&...>) {
            return callable(std::type_identity<Number>{}, values...);
        } else if constexpr (std::is_invocable_v<const Callable&, const ImageSet&, Values&...>) {
            return callable(images, values...);
        } else {
            return callable(values...);
        }
    }
};

template <class Number, class Callable, class... Values>
inline constexpr bool is_callable =
    std::is_invocable_v<const Callable&, std::type_identity<Number>, Values&...> ||
    std::is_invocable_v<const Callable&, const ImageSet&, Values&...> ||
    std::is_invocable_v<const Callable&, Values&...>;

template <class Number, class Function>
struct ReferenceOf;

template <class Number, class R, class... P>
struct ReferenceOf<Number, R(P...)> {
    using Arguments = std::tuple<WithNumber<typename ParameterOf<P>::value, Number>...>;
    static constexpr auto indices = std::index_sequence_for<P...>{};

    template <class Callable>
    static constexpr bool accepts =
        is_callable<Number, Callable, WithNumber<typename ParameterOf<P>::value, Number>...>;

    template <std::size_t... I>
    static Arguments read([[maybe_unused]] std::span<const Word> words, std::index_sequence<I...>) {
        Arguments arguments{};
        ((is_input<P> ? void(std::get<I>(arguments) = take_words<std::tuple_element_t<I, Arguments>>(words))
                      : void()),
         ...);
        return arguments;
    }

    template <class Output, std::size_t... I>
    static void append_outputs(const Arguments& arguments, std::vector<Output>& outputs,
                               std::index_sequence<I...>) {
        ((is_output<P> ? append(std::get<I>(arguments), outputs) : void()), ...);
    }

    // Appends the result, then every out and inout parameter.
    template <class Callable, class Output>
    static void run(const Callable& callable, const ImageSet& images, std::span<const Word> words,
                    std::vector<Output>& outputs) {
        Arguments arguments = read(words, indices);
        const auto call = [&](auto&... values) -> decltype(auto) {
            return Call<Number>{images}(callable, values...);
        };
        if constexpr (std::is_void_v<R>) {
            std::apply(call, arguments);
        } else {
            append(static_cast<WithNumber<R, Number>>(std::apply(call, arguments)), outputs);
        }
        append_outputs(arguments, outputs, indices);
    }
};

}  // namespace detail

// A reference from anything callable with the types of the signature, with double in the place of float:
// (double, glm::dvec3) for float(float, glm::vec3); out and inout parameters as references; optionally the
// images first (const ImageSet&), or std::type_identity<double>, for a template that cannot deduce its number
// type.
template <class Function, class Callable>
[[nodiscard]] Reference make_reference(Callable callable) {
    return [callable](const ImageSet& images, std::span<const Word> words, std::vector<double>& outputs) {
        outputs.clear();
        detail::ReferenceOf<double, Function>::run(callable, images, words, outputs);
    };
}

// Whether a callable also takes intervals in the place of double: a template or generic lambda does.
template <class Function, class Callable>
inline constexpr bool takes_intervals =
    detail::ReferenceOf<numeric::Interval, Function>::template accepts<Callable>;

// What the rules permit, from the same callable, which must do the shader's operations in the shader's order.
template <class Function, class Callable>
requires takes_intervals<Function, Callable>
[[nodiscard]] Permission make_permission(Callable callable) {
    return [callable](const numeric::FloatFormat& format, const ImageSet& images, std::span<const Word> words,
                      Permitted& permitted) {
        permitted.outcomes.clear();
        const auto run = [&] {
            detail::ReferenceOf<numeric::Interval, Function>::run(callable, images, words,
                                                                  permitted.outcomes);
        };
        // Each run appends one outcome; a run that ends early leaves a part of one, which is then not looked
        // at.
        const numeric::Paths::Outcome outcome = numeric::Paths::explore(format, most_paths, run);
        permitted.anything = outcome != numeric::Paths::Outcome::complete;
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
    // What is asked, and the arithmetic whose rules count. Empty: what the lab's variant stands for
    // (judgement_of).
    std::optional<Verdict> verdict{};
    std::optional<numeric::FloatFormat> format{};
};

// What results are held against, and the arithmetic whose rules count.
struct Judgement {
    Verdict verdict = Verdict::budget;
    numeric::FloatFormat format = numeric::float32;
};

// Of shaders compiled in a variant: the strict ones are held against the rules of float32, the relaxed ones
// against those of float16, all others against the documented budget. A case with only_rules is never held
// against a budget.
[[nodiscard]] Judgement judgement_of(const shader::Variant& variant, const Case& check_case);

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

// Whether the results of a function are ones that Vulkan's precision rules permit, with no tolerance of
// anybody's choice. The reference is a template or generic lambda that also takes numeric::Interval in the
// place of double, and does the shader's operations in the shader's order: [](auto x, auto y) { return x / y;
// }. Compile the lab's shaders strictly (LabOptions), or the driver may rearrange them.
template <class Function, class Callable>
requires takes_intervals<Function, Callable>
[[nodiscard]] Result compare_by_rules(const Lab& lab, const std::string& file, const std::string& function,
                                      Callable reference, const Domain& domain,
                                      const RunOptions& options = {}) {
    return run(lab,
               Case{.file = file,
                    .function = function,
                    .signature = SignatureOf<Function>::describe(),
                    .domain = domain,
                    .reference = make_reference<Function>(reference),
                    .permitted = make_permission<Function>(reference),
                    .only_rules = true},
               options);
}

}  // namespace gloam::check
