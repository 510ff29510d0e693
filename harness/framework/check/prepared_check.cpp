// SPDX-License-Identifier: MIT
#include "check/prepared_check.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "backend/gl/kernel.hpp"
#include "check/internal/budget_judge.hpp"
#include "check/internal/kernel_text.hpp"
#include "check/internal/trial.hpp"
#include "numeric/numbers.hpp"

namespace gloam::check {
namespace {

using shader::Scalar;

// The floats that the budget allows around a result.
struct Reach {
    double low;
    double high;
};

double least_float_from(double x) {
    const auto nearest = static_cast<float>(x);
    return static_cast<double>(nearest) < x ? numeric::step(nearest, 1) : nearest;
}

// What the budget allows of each output, and whether it is an interval.
class Allowed {
  public:
    Allowed(const Question& question, const internal::Scalars& scalars) : question_(question) {
        for (const std::size_t words : scalars.output_values) values_.push_back(words);
        scalars_ = scalars.outputs;
    }

    // Whether the outputs that `want` allows are among those that `other` allows.
    [[nodiscard]] bool covered(const std::vector<double>& want, const std::vector<double>& other) const {
        std::size_t first = 0;
        for (const std::size_t words : values_) {
            const double unit = unit_of(want, first, words);
            const double other_unit = unit_of(other, first, words);
            for (std::size_t i = first; i < first + words; ++i)
                if (!covered(i, want[i], unit, other[i], other_unit)) return false;
            first += words;
        }
        return true;
    }

  private:
    [[nodiscard]] bool covered(std::size_t i, double want, double unit, double other,
                               double other_unit) const {
        if (want == other && unit == other_unit) return true;
        if (scalars_[i] != Scalar::float_ || !is_plain(want) || !is_plain(other)) return false;
        const Reach a = reach(want, unit);
        const Reach b = reach(other, other_unit);
        return a.low >= b.low && a.high <= b.high;
    }

    // Beside these values other floats are allowed, too: numeric::ulp_error().
    [[nodiscard]] static bool is_plain(double want) {
        return std::abs(want) >= 0x1p-126 && std::abs(want) <= 0x1.fffffep127;
    }

    [[nodiscard]] Reach reach(double want, double unit) const {
        const double ulp = unit > 0.0 ? unit : numeric::ulp_size(want);
        const double most = std::max(question_.budget.absolute, question_.budget.ulp * ulp);
        return {least_float_from(want - most), -least_float_from(-(want + most))};
    }

    [[nodiscard]] double unit_of(const std::vector<double>& want, std::size_t first,
                                 std::size_t words) const {
        double unit = 0.0;
        for (std::size_t i = first; i < first + words; ++i)
            if (question_.budget.of_largest_component && std::isfinite(want[i]))
                unit = std::max(unit, numeric::ulp_size(want[i]));
        return unit;
    }

    const Question& question_;
    std::vector<std::size_t> values_;
    std::vector<Scalar> scalars_;
};

class Preparation {
  public:
    Preparation(const Question& question, const ImageSet& images)
        : question_(question), images_(images), scalars_(question.signature), allowed_(question, scalars_) {}

    [[nodiscard]] Expectation expect(std::span<const Word> inputs, bool branch) const {
        Sample sample{.inputs = {inputs.begin(), inputs.end()}};
        sample.input_class = internal::class_of(sample.inputs, scalars_.inputs, branch);
        question_.reference(images_, sample.inputs, sample.want);
        Expectation expectation{.input_class = sample.input_class, .wants = {sample.want}};
        if (internal::holds_special(sample, scalars_.inputs)) return expectation;
        if (!question_.promised || question_.promised(sample.inputs)) {
            expectation.criterion = Criterion::budget;
            internal::visit_covered_inputs(question_.budget, scalars_.inputs, sample.inputs,
                                           [&](const auto& moved) { return add(expectation, moved); });
        } else if (internal::is_edge(sample, scalars_)) {
            expectation.criterion = Criterion::edge;
            internal::visit_edge_inputs(scalars_, sample.inputs,
                                        [&](const auto& moved) { return add(expectation, moved); });
        } else {
            expectation.criterion = Criterion::codomain;
        }
        return expectation;
    }

  private:
    bool add(Expectation& expectation, const std::vector<Word>& moved) const {
        std::vector<double> want;
        question_.reference(images_, moved, want);
        const auto is_covered = [&](const std::vector<double>& other) {
            return expectation.criterion == Criterion::edge ? want == other : allowed_.covered(want, other);
        };
        if (std::ranges::none_of(expectation.wants, is_covered)) expectation.wants.push_back(std::move(want));
        return false;
    }

    const Question& question_;
    const ImageSet& images_;
    internal::Scalars scalars_;
    Allowed allowed_;
};

PreparedScenario prepare_scenario(const Question& question, const Domain& domain, const KernelSource& source,
                                  const ImageScenario& scenario, std::size_t count, std::uint64_t seed) {
    const ImageSet images = internal::images_of(scenario, seed);
    const Preparation preparation(question, images);
    PreparedScenario prepared{
        .name = scenario.name,
        .images = images,
        .image_words = image_words(source.images, images, question.function),
        .inputs = domain.draw(count, internal::input_seed_of(question, scenario, seed), scenario.size),
        .expectations = {}};
    internal::set_positive_zeros(prepared.inputs.words, question.signature.input_scalars());
    for (std::size_t i = 0; i < prepared.inputs.count(); ++i)
        prepared.expectations.push_back(
            preparation.expect(prepared.inputs.row(i), prepared.inputs.branch[i]));
    return prepared;
}

}  // namespace

PreparedCheck prepare(const Lab& lab, const Question& question, const RunOptions& options) {
    if (!question.reference || question.only_rules)
        throw std::invalid_argument(question.function + ": has no reference to judge by");
    const KernelSource source = lab.source(question.file, question.function, question.signature);
    internal::require_alone(source, "a browser");
    PreparedCheck prepared;
    try {
        prepared.kernel =
            internal::gl_kernel_code(shader::Language::es300, source, lab.options().include_roots);
    } catch (const backend::Unsupported& reason) {
        prepared.unsupported = reason.what();
        return prepared;
    }
    prepared.row_words = gl::kernel_row(question.signature.output_words(), source.images.size());
    prepared.targets = gl::kernel_targets(prepared.row_words);
    const Domain domain = internal::domain_of(lab, question);
    internal::for_each_scenario(
        question, options.inputs, [&](const ImageScenario& scenario, std::size_t share) {
            prepared.scenarios.push_back(
                prepare_scenario(question, domain, source, scenario, share, options.seed));
        });
    return prepared;
}

}  // namespace gloam::check
