// SPDX-License-Identifier: MIT
#include "judge/internal/budget_judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "numeric/interval.hpp"
#include "numeric/numbers.hpp"

namespace gloam::judge::internal {

using namespace subject;

using module::Scalar;
using numeric::infinity;

namespace {

InputClass class_of(double value, const numeric::FloatFormat& format) {
    using enum InputClass;
    constexpr std::array classes{ordinary, zero, subnormal, huge, infinite, nan};  // as FloatClass has them
    return classes.at(static_cast<std::size_t>(numeric::classify(value, format)));
}

}  // namespace

InputClass class_of(std::span<const Word> inputs, const std::vector<Scalar>& scalars, bool branch) {
    auto worst = branch ? InputClass::branch : InputClass::ordinary;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        if (module::is_float(scalars[i]))
            worst = std::max(worst, class_of(from_word<double>(inputs[i]), format_of(scalars[i])));
    return worst;
}

void set_positive_zeros(std::span<Word> words, const std::vector<Scalar>& scalars) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (module::is_float(scalars[i % scalars.size()]) && from_word<float>(words[i]) == 0.0F) words[i] = 0;
    }
}

bool holds_special(const Sample& sample, const std::vector<Scalar>& scalars) {
    for (std::size_t i = 0; i < sample.inputs.size(); ++i) {
        if (!module::is_float(scalars[i])) continue;
        const double value = from_word<double>(sample.inputs[i]);
        if (!std::isfinite(value) || (value == 0.0 && std::signbit(value))) return true;
    }
    return std::ranges::any_of(sample.want, [](double want) { return !std::isfinite(want); });
}

namespace {

constexpr std::size_t corner_words = 6;  // up to this many float inputs, all corners are tried

double fraction_of(double error, double allowed) {
    if (error == 0.0) return 0.0;
    return allowed > 0.0 ? error / allowed : infinity;
}

std::vector<Word> flushed(const std::vector<Scalar>& scalars, std::span<const Word> inputs) {
    std::vector<Word> moved(inputs.begin(), inputs.end());
    for (std::size_t i = 0; i < moved.size(); ++i) {
        if (!module::is_float(scalars[i])) continue;
        const auto value = from_word<double>(moved[i]);
        if (numeric::classify(value, format_of(scalars[i])) == numeric::FloatClass::subnormal)
            moved[i] = to_word(std::copysign(0.0, value));
    }
    return moved;
}

// Whether a value is meant exactly: 0 and other small whole numbers are counts, sizes and ends of ranges,
// which a calculation before the function yields without an error.
bool is_meant_exactly(double value) {
    constexpr double largest = 256.0;
    return std::abs(value) <= largest && value == std::trunc(value);
}

// Moves each float input that is not meant exactly alone, then all of them together in every combination of
// directions.
bool visit_moved(const std::vector<Scalar>& scalars, std::span<const Word> inputs, int steps,
                 const InputVisitor& visit) {
    std::vector<std::size_t> floats;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (module::is_float(scalars[i]) && !is_meant_exactly(from_word<double>(inputs[i])))
            floats.push_back(i);
    }
    const auto move = [&](std::vector<Word>& words, std::size_t i, bool up) {
        words[i] = stepped_float(scalars[i], words[i], up ? steps : -steps);
    };
    for (const std::size_t i : floats) {
        for (const bool up : {false, true}) {
            std::vector<Word> moved(inputs.begin(), inputs.end());
            move(moved, i, up);
            if (visit(moved)) return true;
        }
    }
    if (floats.size() < 2 || floats.size() > corner_words) return false;
    for (std::size_t corner = 0; corner < std::size_t{1} << floats.size(); ++corner) {
        std::vector<Word> moved(inputs.begin(), inputs.end());
        for (std::size_t f = 0; f < floats.size(); ++f) move(moved, floats[f], ((corner >> f) & 1U) != 0);
        if (visit(moved)) return true;
    }
    return false;
}

}  // namespace

std::vector<numeric::Bounds> allowed_around(const Question& question, const std::vector<double>& want) {
    using numeric::Bounds;
    const Budget& budget = question.budget;
    const std::vector<Scalar> scalars = question.signature.output_scalars();
    std::vector<Bounds> bounds;
    for (const std::size_t words : question.signature.output_values()) {
        const std::size_t first = bounds.size();
        double largest = 0.0;
        for (std::size_t i = first; i < first + words; ++i)
            if (std::isfinite(want[i])) largest = std::max(largest, std::abs(want[i]));
        for (std::size_t i = first; i < first + words; ++i) {
            const double unit = format_of(scalars[i]).ulp(budget.of_largest_component ? largest : want[i]);
            const double reach = std::max(budget.absolute, budget.ulp * unit);
            const bool near = module::is_float(scalars[i]) && std::isfinite(want[i]);
            bounds.push_back(std::isnan(want[i]) ? Bounds::only_nan()
                             : near              ? Bounds{want[i] - reach, want[i] + reach, false}
                                                 : Bounds::point(want[i]));
        }
    }
    return bounds;
}

bool visit_covered_inputs(const Budget& budget, const std::vector<Scalar>& scalars,
                          std::span<const Word> inputs, const InputVisitor& visit) {
    if (visit(flushed(scalars, inputs))) return true;
    for (int steps = 1; steps <= budget.backward_ulp; ++steps)
        if (visit_moved(scalars, inputs, steps, visit)) return true;
    return false;
}

bool has_codomain(const Question& question, const Scalars& scalars) {
    const bool bounded = question.codomain.low > -infinity || question.codomain.high < infinity;
    return bounded &&
           std::ranges::any_of(scalars.outputs, [](Scalar scalar) { return scalar != Scalar::bool_; });
}

double unit_of(const Budget& budget, std::span<const double> want, const numeric::FloatFormat& format) {
    double unit = 0.0;
    for (const double w : want) {
        if (budget.of_largest_component && std::isfinite(w)) unit = std::max(unit, format.ulp(w));
    }
    return unit;
}

ErrorSize float_error(const Budget& budget, double got, double want, double unit,
                      const numeric::FloatFormat& format) {
    // An end of permitted bounds may be between two values.
    const double value = format == numeric::float32 ? static_cast<double>(static_cast<float>(got)) : got;
    const double absolute = numeric::absolute_error(value, want, format);
    const double ulp =
        unit > 0.0 && std::isfinite(absolute) ? absolute / unit : numeric::ulp_error(value, want, format);
    return {ulp, absolute, std::min(fraction_of(ulp, budget.ulp), fraction_of(absolute, budget.absolute))};
}

namespace {

constexpr ErrorSize infinite{.ulp = infinity, .absolute = infinity, .fraction = infinity};

bool inside_codomain(const Question& question, const Scalars& scalars, std::span<const Word> got) {
    for (std::size_t i = 0; i < got.size(); ++i) {
        if (scalars.outputs[i] == Scalar::bool_) continue;
        const double value = number_at(scalars.outputs[i], got[i]);
        if (!(value >= question.codomain.low && value <= question.codomain.high)) return false;
    }
    return true;
}

void add_value(const Budget& budget, std::span<const Word> got, std::span<const double> want,
               std::span<const Scalar> scalars, ErrorSize& error) {
    const numeric::FloatFormat& format = format_of(scalars.front());
    const double unit = unit_of(budget, want, format);
    for (std::size_t i = 0; i < got.size(); ++i) {
        if (module::is_float(scalars[i])) {
            ErrorSize here = float_error(budget, number_at(scalars[i], got[i]), want[i], unit, format);
            if (!(here.absolute > budget.absolute)) here.ulp = 0.0;
            error.raise(here);
        } else if (number_at(scalars[i], got[i]) != want[i]) {
            error = infinite;
        }
    }
}

// Against one candidate for the exact result.
ErrorSize error_against(const Budget& budget, const Scalars& scalars, std::span<const Word> got,
                        const std::vector<double>& want) {
    ErrorSize error;
    std::size_t first = 0;
    for (const std::size_t words : scalars.output_values) {
        add_value(budget, got.subspan(first, words), std::span(want).subspan(first, words),
                  std::span(scalars.outputs).subspan(first, words), error);
        first += words;
    }
    return error;
}

}  // namespace

// The error against the reference at the input itself. If that fails, the least error over the inputs that
// the budget also covers: subnormals flushed to zero, and inputs within the backward budget.
ErrorSize error_of(const Question& question, const ImageSet& images, const Scalars& scalars,
                   const Sample& sample, bool promised) {
    if (!inside_codomain(question, scalars, sample.got)) return infinite;
    if (!promised) return {};
    ErrorSize best = error_against(question.budget, scalars, sample.got, sample.want);
    std::vector<double> candidate;
    const auto try_at = [&](const std::vector<Word>& inputs) {
        question.reference(images, inputs, candidate);
        const ErrorSize error = error_against(question.budget, scalars, sample.got, candidate);
        if (error.fraction < best.fraction) best = error;
        return best.fraction <= 1.0;
    };
    if (best.fraction > 1.0 && question.reference)
        visit_covered_inputs(question.budget, scalars.inputs, sample.inputs, try_at);
    return best;
}

namespace {

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

bool same_value(std::span<const Word> got, std::span<const double> want, std::span<const Scalar> scalars,
                const Budget& budget) {
    double largest = 0.01;
    for (const double w : want) {
        if (std::isfinite(w)) largest = std::max(largest, std::abs(w));
    }
    // A result below the normal numbers may be flushed.
    const double allowed = std::max({tolerance * largest, budget.absolute, 0x1p-126});
    for (std::size_t i = 0; i < got.size(); ++i) {
        const double number = number_at(scalars[i], got[i]);
        if (!same_number(number, want[i], module::is_float(scalars[i]) ? allowed : 0.0)) return false;
    }
    return true;
}

bool same_outputs(std::span<const Word> got, const std::vector<double>& want, const Scalars& scalars,
                  const Budget& budget) {
    std::size_t first = 0;
    for (const std::size_t words : scalars.output_values) {
        if (!same_value(got.subspan(first, words), std::span(want).subspan(first, words),
                        std::span(scalars.outputs).subspan(first, words), budget))
            return false;
        first += words;
    }
    return true;
}

// Visits the inputs a few ULP away, or as far as the budget covers, whose results an edge may also have.
// Returns whether a visit ended it.
bool visit_edge_inputs(const Budget& budget, const Scalars& scalars, std::span<const Word> inputs,
                       const InputVisitor& visit) {
    const int most = std::max(most_steps, budget.backward_ulp);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (!module::is_float(scalars.inputs[i])) continue;
        if (!is_usual(std::abs(from_word<double>(inputs[i])))) continue;
        for (int steps = -most; steps <= most; ++steps) {
            std::vector<Word> moved(inputs.begin(), inputs.end());
            moved[i] = stepped_float(scalars.inputs[i], moved[i], steps);
            if (visit(moved)) return true;
        }
    }
    return false;
}

}  // namespace

bool is_edge(const Sample& sample, const Scalars& scalars) {
    const bool special = sample.input_class == InputClass::zero ||
                         sample.input_class == InputClass::infinite || sample.input_class == InputClass::nan;
    if (!special) return false;
    for (std::size_t i = 0; i < sample.inputs.size(); ++i) {
        if (!module::is_float(scalars.inputs[i])) continue;
        const double value = std::abs(from_word<double>(sample.inputs[i]));
        if (std::isfinite(value) && value != 0.0 && !is_usual(value)) return false;
    }
    return true;
}

bool holds_at_edge(const Question& question, const ImageSet& images, const Scalars& scalars,
                   const Sample& sample) {
    if (same_outputs(sample.got, sample.want, scalars, question.budget)) return true;
    std::vector<double> want;
    return visit_edge_inputs(question.budget, scalars, sample.inputs, [&](const std::vector<Word>& moved) {
        question.reference(images, moved, want);
        return same_outputs(sample.got, want, scalars, question.budget);
    });
}

}  // namespace gloam::judge::internal
