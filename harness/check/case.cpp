// SPDX-License-Identifier: MIT
#include "check/case.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace gloam::check {
namespace {

// Runs and judges one scenario (or the only run of a function without images).
void run_inputs(const Lab& lab, const Case& check_case, const KernelCore& kernel,
                const ImageScenario& scenario, const RunOptions& options, Result& result) {
    numeric::Random random(options.seed ^ numeric::hash_of(scenario.name));
    const ImageSet images = scenario.make ? scenario.make(scenario.size, random) : ImageSet{};
    const std::uint64_t seed = options.seed ^ numeric::hash_of(check_case.function + scenario.name);
    const Domain::Inputs inputs = check_case.domain.draw(options.inputs, seed, scenario.size);
    if (inputs.width != kernel.input_words()) {
        throw std::invalid_argument(fmt::format("{}: the domain draws {} words, the function takes {}",
                                                check_case.function, inputs.width, kernel.input_words()));
    }
    const KernelCore::Result outputs = kernel.run(inputs.words, inputs.count(), images);
    lab.require_silent_validation();
    if (outputs.fault && !result.fault) result.fault = outputs.fault;
    const Rules rules{.signature = check_case.signature,
                      .reference = check_case.reference,
                      .budget = check_case.budget,
                      .codomain = check_case.codomain,
                      .promised = check_case.promised,
                      .judge_nan = lab.device().info().float32.preserves_signed_zero_inf_nan,
                      .verdict = result.verdict,
                      .permitted = check_case.permitted,
                      .format = options.format};
    result.census.merge(judge(rules, inputs, outputs.outputs, images, scenario.name));
}

}  // namespace

Result run(const Lab& lab, const Case& check_case, const RunOptions& options) {
    const KernelCore kernel = lab.kernel(check_case.file, check_case.function, check_case.signature);
    Result result{.file = check_case.file,
                  .function = check_case.function,
                  .signature = check_case.signature,
                  .budget = check_case.budget,
                  .verdict = check_case.only_rules ? Verdict::rules : options.verdict};
    if (check_case.scenarios.empty()) {
        run_inputs(lab, check_case, kernel, {}, options, result);
        return result;
    }
    const std::size_t scenarios = check_case.scenarios.size();
    for (std::size_t i = 0; i < scenarios; ++i) {
        RunOptions share = options;
        share.inputs = options.inputs / scenarios + (i < options.inputs % scenarios ? 1 : 0);
        run_inputs(lab, check_case, kernel, check_case.scenarios[i], share, result);
    }
    return result;
}

}  // namespace gloam::check
