// SPDX-License-Identifier: MIT
#include "check/case.hpp"

#include "check/internal/trial.hpp"

namespace gloam::check {

Result run(const Lab& lab, const Case& check_case, const RunOptions& options) {
    const KernelCore kernel = lab.kernel(check_case.file, check_case.function, check_case.signature);
    Result result = internal::empty_result(check_case, options.verdict);
    internal::for_each_scenario(
        check_case, options.inputs, [&](const ImageScenario& scenario, std::size_t share) {
            const internal::Trial trial(lab, check_case, kernel, scenario, options.seed, result.verdict,
                                        options.format);
            trial.evaluate(check_case.domain.draw(share, trial.input_seed(), scenario.size), result);
        });
    return result;
}

}  // namespace gloam::check
