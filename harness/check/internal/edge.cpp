// SPDX-License-Identifier: MIT
#include "check/internal/edge.hpp"

#include <algorithm>
#include <cmath>

#include "numeric/ulp.hpp"

namespace gloam::check::internal {
namespace {

using shader::Scalar;

constexpr double largest_result = 1e30;  // larger results are not compared
constexpr double largest_usual = 1e4;
constexpr double smallest_usual = 1e-4;
constexpr double tolerance = 1.0 / 256.0;
constexpr int most_steps = 4;  // ULP

bool is_usual(double magnitude) {
    return magnitude >= smallest_usual && magnitude <= largest_usual;
}

bool same_number(double got, double want, double allowed) {
    if (std::isnan(want)) return std::isnan(got);
    if (std::isfinite(want) && std::abs(want) > largest_result) return true;
    return got == want || std::abs(got - want) <= allowed;
}

bool same_value(std::span<const Word> got, std::span<const double> want, Scalar scalar,
                const Budget& budget) {
    double largest = 0.01;
    for (const double w : want) {
        if (std::isfinite(w)) largest = std::max(largest, std::abs(w));
    }
    // A result below the normal numbers may be flushed.
    const double allowed = std::max({tolerance * largest, budget.absolute, 0x1p-126});
    for (std::size_t i = 0; i < got.size(); ++i) {
        const double number = as_number(scalar, got[i]);
        if (!same_number(number, want[i], scalar == Scalar::float_ ? allowed : 0.0)) return false;
    }
    return true;
}

bool same_outputs(std::span<const Word> got, const std::vector<double>& want, const Scalars& scalars,
                  const Budget& budget) {
    std::size_t first = 0;
    for (const std::size_t words : scalars.output_values) {
        if (!same_value(got.subspan(first, words), std::span(want).subspan(first, words),
                        scalars.outputs[first], budget))
            return false;
        first += words;
    }
    return true;
}

}  // namespace

bool is_edge(const Sample& sample, const Scalars& scalars) {
    const bool special = sample.input_class == InputClass::zero ||
                         sample.input_class == InputClass::infinite || sample.input_class == InputClass::nan;
    if (!special) return false;
    for (std::size_t i = 0; i < sample.inputs.size(); ++i) {
        if (scalars.inputs[i] != Scalar::float_) continue;
        const auto value = std::abs(static_cast<double>(from_word<float>(sample.inputs[i])));
        if (std::isfinite(value) && value != 0.0 && !is_usual(value)) return false;
    }
    return true;
}

bool visit_edge_inputs(const Scalars& scalars, std::span<const Word> inputs, const InputVisitor& visit) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (scalars.inputs[i] != Scalar::float_) continue;
        if (!is_usual(std::abs(static_cast<double>(from_word<float>(inputs[i]))))) continue;
        for (int steps = -most_steps; steps <= most_steps; ++steps) {
            std::vector<Word> moved(inputs.begin(), inputs.end());
            moved[i] = to_word(numeric::step(from_word<float>(moved[i]), steps));
            if (visit(moved)) return true;
        }
    }
    return false;
}

bool holds_at_edge(const Question& question, const ImageSet& images, const Scalars& scalars,
                   const Sample& sample) {
    if (same_outputs(sample.got, sample.want, scalars, question.budget)) return true;
    std::vector<double> want;
    return visit_edge_inputs(scalars, sample.inputs, [&](const std::vector<Word>& moved) {
        question.reference(images, moved, want);
        return same_outputs(sample.got, want, scalars, question.budget);
    });
}

}  // namespace gloam::check::internal
