// SPDX-License-Identifier: MIT
#include "check/judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <optional>
#include <thread>

#include "check/internal/budget_judge.hpp"
#include "check/internal/edge.hpp"
#include "check/internal/rules_judge.hpp"
#include "numeric/float_class.hpp"

namespace gloam::check {
namespace {

using shader::Scalar;

// The class of one input, and the float words it was read from.
InputClass class_of(std::span<const Word> inputs, const std::vector<Scalar>& scalars, bool branch) {
    auto worst = branch ? InputClass::branch : InputClass::ordinary;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (scalars[i] != Scalar::float_) continue;
        auto here = InputClass::ordinary;
        switch (numeric::classify(from_word<float>(inputs[i]))) {
            case numeric::FloatClass::ordinary:
                break;
            case numeric::FloatClass::zero:
                here = InputClass::zero;
                break;
            case numeric::FloatClass::subnormal:
                here = InputClass::subnormal;
                break;
            case numeric::FloatClass::huge:
                here = InputClass::huge;
                break;
            case numeric::FloatClass::infinite:
                here = InputClass::infinite;
                break;
            case numeric::FloatClass::nan:
                here = InputClass::nan;
                break;
        }
        worst = std::max(worst, here);
    }
    return worst;
}

class Judge {
  public:
    Judge(const Rules& rules, const ImageSet& images)
        : rules_(rules), images_(images), scalars_(rules.signature), budget_(rules, images, scalars_) {
        if (rules.verdict == Verdict::rules) permitted_.emplace(rules, images, scalars_);
    }

    void add(Census& census, Sample& sample, bool branch) {
        sample.input_class = class_of(sample.inputs, scalars_.inputs, branch);
        rules_.reference(images_, sample.inputs, sample.want);
        if (sample.want.size() != scalars_.outputs.size()) {
            throw std::logic_error(fmt::format("the reference gave {} output words, the signature has {}",
                                               sample.want.size(), scalars_.outputs.size()));
        }
        if (!rules_.judge_nan && holds_special(sample)) {
            census.add_recorded(sample.input_class);
            return;
        }
        const internal::Error error = budget_.measure(sample);
        sample.ulp = error.ulp;
        sample.absolute = error.absolute;
        sample.budget_fraction = error.fraction;
        sample.fraction = error.fraction;
        if (permitted_) add_permitted(census, sample);
        const bool promised = !rules_.promised || rules_.promised(sample.inputs);
        const bool accurate = promised && sample.budget_fraction <= 1.0;
        if (rules_.judge_edges && !accurate && internal::is_edge(sample, scalars_) &&
            !internal::holds_at_edge(rules_, images_, scalars_, sample))
            sample.fraction = std::numeric_limits<double>::infinity();
        census.add(sample, sample.fraction > 1.0);
    }

  private:
    void add_permitted(Census& census, Sample& sample) {
        const bool anything = permitted_->measure(sample);
        if (anything) census.add_unbounded(sample);
        const bool promised = !rules_.promised || rules_.promised(sample.inputs);
        const bool usual = sample.input_class <= InputClass::zero;
        if (anything || !promised || !usual) return;
        const internal::Error largest = permitted_->largest_permitted(sample, budget_);
        census.add_guarantee({largest.ulp, largest.absolute, largest.fraction});
    }

    bool holds_special(const Sample& sample) const {
        for (std::size_t i = 0; i < sample.inputs.size(); ++i) {
            if (scalars_.inputs[i] != Scalar::float_) continue;
            const auto value = from_word<float>(sample.inputs[i]);
            if (!std::isfinite(value) || (value == 0.0F && std::signbit(value))) return true;
        }
        return std::ranges::any_of(sample.want, [](double want) { return !std::isfinite(want); });
    }

    const Rules& rules_;
    const ImageSet& images_;
    internal::Scalars scalars_;
    internal::BudgetJudge budget_;
    std::optional<internal::RulesJudge> permitted_;
};

}  // namespace

std::string to_text(const Budget& budget) {
    std::string text;
    if (budget.ulp > 0.0)
        text = fmt::format("{:g} ulp{}", budget.ulp,
                           budget.of_largest_component ? " of the largest component" : "");
    if (budget.absolute > 0.0)
        text += fmt::format("{}{:g} absolute", text.empty() ? "" : " or ", budget.absolute);
    if (text.empty()) text = "exact";
    if (budget.backward_ulp > 0) text += fmt::format(" at inputs within {} ulp", budget.backward_ulp);
    return text;
}

Census judge(const Rules& rules, const Domain::Inputs& inputs, std::span<const Word> outputs,
             const ImageSet& images, const std::string& scenario, std::span<double> fractions) {
    const std::size_t width = rules.signature.output_words();
    const auto part = [&](std::size_t begin, std::size_t end) {
        Judge judge(rules, images);
        Census census;
        Sample sample{.scenario = scenario};
        for (std::size_t i = begin; i < end; ++i) {
            const auto row = inputs.row(i);
            const auto got = outputs.subspan(i * width, width);
            sample.index = i;
            sample.inputs.assign(row.begin(), row.end());
            sample.got.assign(got.begin(), got.end());
            sample.want.clear();
            sample.fraction = 0.0;
            judge.add(census, sample, inputs.branch[i]);
            if (!fractions.empty()) fractions[i] = sample.fraction;
        }
        return census;
    };
    const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t share = inputs.count() / threads + 1;
    std::vector<std::future<Census>> parts;
    for (std::size_t begin = 0; begin < inputs.count(); begin += share) {
        parts.push_back(std::async(std::launch::async, part, begin, std::min(begin + share, inputs.count())));
    }
    Census all;
    for (auto& census : parts) all.merge(census.get());
    return all;
}

}  // namespace gloam::check
