// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "check/internal/budget_judge.hpp"
#include "check/reproduction.hpp"
#include "numeric/ulp.hpp"

namespace gloam::check {
namespace {

using numeric::Bounds;
using shader::Scalar;

// The budget around one result of the reference, where `unit` is the size of an ULP.
Bounds around(double want, double unit, const Budget& budget) {
    if (std::isnan(want)) return Bounds::only_nan();
    if (!std::isfinite(want)) return Bounds::point(want);
    const double reach = std::max(budget.absolute, budget.ulp * unit);
    return {want - reach, want + reach, false};
}

std::vector<Bounds> around(const Question& question, const std::vector<double>& want) {
    const std::vector<Scalar> scalars = question.signature.output_scalars();
    std::vector<Bounds> bounds;
    for (const std::size_t words : question.signature.output_values()) {
        const std::size_t first = bounds.size();
        double largest = 0.0;
        for (std::size_t i = first; i < first + words; ++i) {
            if (std::isfinite(want[i])) largest = std::max(largest, std::abs(want[i]));
        }
        for (std::size_t i = first; i < first + words; ++i) {
            if (scalars[i] != Scalar::float_) {
                bounds.push_back(Bounds::point(want[i]));
                continue;
            }
            const double at = question.budget.of_largest_component ? largest : want[i];
            bounds.push_back(around(want[i], numeric::ulp_size(at), question.budget));
        }
    }
    return bounds;
}

}  // namespace

std::vector<Bounds> allowed_outputs(const Question& question, const ImageSet& images, const Sample& sample) {
    if (!sample.permitted.empty()) return sample.permitted;
    const std::vector<Scalar> scalars = question.signature.output_scalars();
    const Bounds codomain{question.codomain.low, question.codomain.high, false};
    std::vector<Bounds> bounds(scalars.size(), codomain);
    // Elsewhere only the codomain is promised.
    if (question.promised && !question.promised(sample.inputs)) return bounds;
    bounds = around(question, sample.want);
    std::vector<double> want;
    const auto add = [&](const std::vector<Word>& inputs) {
        question.reference(images, inputs, want);
        std::ranges::transform(bounds, around(question, want), bounds.begin(), numeric::hull);
        return false;
    };
    internal::visit_covered_inputs(question.budget, question.signature.input_scalars(), sample.inputs, add);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        if (scalars[i] != Scalar::float_ || bounds[i].empty()) continue;
        bounds[i].low = std::max(bounds[i].low, codomain.low);
        bounds[i].high = std::min(bounds[i].high, codomain.high);
    }
    return bounds;
}

}  // namespace gloam::check
