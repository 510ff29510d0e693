// SPDX-License-Identifier: MIT
#include "check/internal/trial.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace gloam::check::internal {
namespace {

bool same_bits(const std::vector<shader::Scalar>& scalars, std::span<const Word> a, std::span<const Word> b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const bool both_nan = scalars[i] == shader::Scalar::float_ && std::isnan(from_word<float>(a[i])) &&
                              std::isnan(from_word<float>(b[i]));
        if (a[i] != b[i] && !both_nan) return false;
    }
    return true;
}

}  // namespace

Trial::Trial(const Lab& lab, const Case& check_case, const KernelCore& kernel, const ImageScenario& scenario,
             std::uint64_t seed, Verdict verdict)
    : lab_(lab),
      kernel_(kernel),
      scenario_(scenario),
      input_seed_(seed ^ numeric::hash_of(check_case.function + scenario.name)),
      images_(images_of(scenario, seed)),
      rules_{.signature = check_case.signature,
             .reference = check_case.reference,
             .budget = check_case.budget,
             .codomain = check_case.codomain,
             .promised = check_case.promised,
             .judge_edges = !check_case.only_rules && !lab.options().variant.relaxed,
             .judge_nan = lab.device().info().float32.preserves_signed_zero_inf_nan,
             .verdict = verdict} {}

KernelCore::Result Trial::run(const Domain::Inputs& inputs, Result& result) const {
    if (inputs.width != kernel_.input_words()) {
        throw std::invalid_argument(fmt::format("{}: the domain draws {} words, the function takes {}",
                                                result.function, inputs.width, kernel_.input_words()));
    }
    KernelCore::Result outputs = kernel_.run(inputs.words, inputs.count(), images_);
    lab_.require_silent_validation();
    if (outputs.fault && !result.fault) result.fault = outputs.fault;
    return outputs;
}

void Trial::evaluate(const Domain::Inputs& inputs, Result& result, std::span<double> fractions) const {
    const KernelCore::Result outputs = run(inputs, result);
    Rules rules = rules_;
    rules.modules = outputs.modules;
    result.census.merge(judge(rules, inputs, outputs.outputs, images_, scenario_.name, fractions));
}

void Trial::compare_constants(const Domain::Inputs& inputs, const ConstantKernel& constants,
                              Result& result) const {
    const KernelCore::Result at_run_time = run(inputs, result);
    const KernelCore::Result folded = constants.run(inputs.words, inputs.count(), images_);
    lab_.require_silent_validation();
    Rules rules = rules_;
    rules.judge_nan = rules.judge_nan && constants.preserves_nan();
    rules.modules = folded.modules;
    result.census.merge(judge(rules, inputs, folded.outputs, images_, scenario_.name));
    const std::size_t width = kernel_.output_words();
    const std::vector<shader::Scalar> scalars = rules_.signature.output_scalars();
    for (std::size_t i = 0; i < inputs.count(); ++i) {
        const auto row = [&](const std::vector<Word>& words) {
            return std::span(words).subspan(i * width, width);
        };
        if (!same_bits(scalars, row(at_run_time.outputs), row(folded.outputs))) ++result.differs;
    }
}

ImageSet images_of(const ImageScenario& scenario, std::uint64_t seed) {
    numeric::Random random(seed ^ numeric::hash_of(scenario.name));
    return scenario.make ? scenario.make(scenario.size, random) : ImageSet{};
}

void for_each_scenario(const Case& check_case, std::size_t inputs,
                       const std::function<void(const ImageScenario& scenario, std::size_t share)>& visit) {
    if (check_case.scenarios.empty()) return visit(ImageScenario{}, inputs);
    const std::size_t scenarios = check_case.scenarios.size();
    for (std::size_t i = 0; i < scenarios; ++i) {
        visit(check_case.scenarios[i], inputs / scenarios + (i < inputs % scenarios ? 1 : 0));
    }
}

Result empty_result(const Case& check_case, Verdict verdict) {
    return {.file = check_case.file,
            .function = check_case.function,
            .signature = check_case.signature,
            .budget = check_case.budget,
            .verdict = verdict};
}

}  // namespace gloam::check::internal
