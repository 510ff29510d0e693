// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "judge/answer.hpp"
#include "subject/domain.hpp"
#include "subject/images.hpp"
#include "subject/own_function.hpp"
#include "subject/signature.hpp"

namespace gloam::judge {

// A reference without its C++ types: input words in, one double for each output word out, as number_at()
// reads it. If a question has none, the module interpreted in double replaces it.
using Reference = std::function<void(const subject::ImageSet& images, std::span<const Word> inputs,
                                     std::vector<double>& outputs)>;

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
    subject::Signature signature;
    subject::Domain domain;
    Reference reference;  // empty: the rules judge, and the module in double is the reference
    Budget budget;
    Codomain codomain;
    // Inputs for which the budget is promised; empty: all. For other inputs, for example after overflow, only
    // the codomain and the documented results for zero, infinity and NaN are judged.
    std::function<bool(std::span<const Word>)> promised;
    // Whether every input of the domain has a defined result. If not, an input for which the function reads
    // outside an array, for example, is not judged; otherwise it is a failure.
    bool defined = true;
    // Whether every bool of the result has to be true: a false one that the rules permit is a failure of the
    // function itself.
    bool must_hold = false;
    std::vector<subject::ImageScenario> scenarios;  // empty: the function reads no image
    bool only_rules = false;  // it documents no accuracy: judged by the rules in every variant
    // Of a whole pass: runs and judges it. Its inputs are pixels, and there is no kernel of the function.
    std::function<Answer(const subject::Lab&)> answers;

    // What judges its results in a variant: in strict and relaxed ones and after steps the rules alone, in
    // all others the documented budget and the rules. With only_rules or without a reference it is never a
    // budget.
    [[nodiscard]] Criterion criterion_in(const module::Variant& variant) const;
    // Its scenarios, each with its share of so many inputs, 1 at least; if it reads no image, all inputs with
    // an empty scenario.
    [[nodiscard]] std::vector<std::pair<subject::ImageScenario, std::size_t>> shares(
        std::size_t inputs) const;
    // An empty one if it reads no image.
    [[nodiscard]] subject::ImageScenario first_scenario() const;
    // The one of this name; empty: without images. Throws std::invalid_argument if it has no such images.
    [[nodiscard]] subject::ImageScenario scenario_of(const std::string& images) const;
};

namespace detail {

// Calls a reference, with the images as first argument if it takes them.
template <class Callable, class... Values>
decltype(auto) call(const Callable& callable, const subject::ImageSet& images, Values&... values) {
    if constexpr (std::is_invocable_v<const Callable&, const subject::ImageSet&, Values&...>) {
        return callable(images, values...);
    } else {
        return callable(values...);
    }
}

template <class Function>
struct ReferenceOf;

template <class R, class... P>
struct ReferenceOf<R(P...)> {
    // Appends the result, then every out and inout parameter.
    template <class Callable>
    static void run(const Callable& callable, const subject::ImageSet& images, std::span<const Word> words,
                    std::vector<double>& outputs) {
        std::tuple<subject::InDouble<typename subject::ParameterOf<P>::value>...> arguments{};
        const auto with = [&](auto&... values) {
            ((subject::is_input<P>
                  ? void(values = subject::take_words<std::remove_cvref_t<decltype(values)>>(words))
                  : void()),
             ...);
            if constexpr (std::is_void_v<R>) {
                call(callable, images, values...);
            } else {
                subject::append_numbers(static_cast<subject::InDouble<R>>(call(callable, images, values...)),
                                        outputs);
            }
            ((subject::is_output<P> ? subject::append_numbers(values, outputs) : void()), ...);
        };
        std::apply(with, arguments);
    }
};

}  // namespace detail

// Makes a reference from a callable with the types of the signature, with double in place of float: (double,
// glm::dvec3) for float(float, glm::vec3). Out and inout parameters are references. The images (const
// ImageSet&) can be the first argument.
template <class Function, class Callable>
[[nodiscard]] Reference make_reference(Callable callable) {
    return [callable](const subject::ImageSet& images, std::span<const Word> words,
                      std::vector<double>& outputs) {
        outputs.clear();
        detail::ReferenceOf<Function>::run(callable, images, words, outputs);
    };
}

// Makes a `promised` test from a predicate on typed inputs. It is called with the exact values of in and
// inout parameters.
template <class Function, class Predicate>
[[nodiscard]] std::function<bool(std::span<const Word>)> make_predicate(Predicate predicate) {
    return [predicate](std::span<const Word> words) {
        return std::apply(predicate,
                          subject::take_words<typename subject::SignatureOf<Function>::Inputs>(words));
    };
}

// The check of any function by the rules alone, of its domain_of() these ranges; the images behind its
// prototypes have random content. If every parameter has a range, their inputs are promised to have defined
// results.
[[nodiscard]] Question question_of(const subject::Lab& lab, const subject::OwnFunction& own,
                                   const subject::Ranges& ranges);

}  // namespace gloam::judge
