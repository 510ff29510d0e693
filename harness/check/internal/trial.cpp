// SPDX-License-Identifier: MIT
#include "check/internal/trial.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace gloam::check::internal {

Trial::Trial(const Lab& lab, const Case& check_case, const KernelCore& kernel, const ImageScenario& scenario,
             std::uint64_t seed, Verdict verdict, const numeric::FloatFormat& format)
    : lab_(lab),
      kernel_(kernel),
      scenario_(scenario),
      input_seed_(seed ^ numeric::hash_of(check_case.function + scenario.name)),
      rules_{.signature = check_case.signature,
             .reference = check_case.reference,
             .budget = check_case.budget,
             .codomain = check_case.codomain,
             .promised = check_case.promised,
             .judge_nan = lab.device().info().float32.preserves_signed_zero_inf_nan,
             .verdict = verdict,
             .permitted = check_case.permitted,
             .format = format} {
    numeric::Random random(seed ^ numeric::hash_of(scenario.name));
    if (scenario.make) images_ = scenario.make(scenario.size, random);
}

void Trial::evaluate(const Domain::Inputs& inputs, Result& result, std::span<double> fractions) const {
    if (inputs.width != kernel_.input_words()) {
        throw std::invalid_argument(fmt::format("{}: the domain draws {} words, the function takes {}",
                                                result.function, inputs.width, kernel_.input_words()));
    }
    const KernelCore::Result outputs = kernel_.run(inputs.words, inputs.count(), images_);
    lab_.require_silent_validation();
    if (outputs.fault && !result.fault) result.fault = outputs.fault;
    result.census.merge(judge(rules_, inputs, outputs.outputs, images_, scenario_.name, fractions));
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
            .verdict = check_case.only_rules ? Verdict::rules : verdict};
}

}  // namespace gloam::check::internal
