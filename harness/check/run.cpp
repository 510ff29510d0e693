// SPDX-License-Identifier: MIT
#include "check/run.hpp"

#include "check/constant_kernel.hpp"
#include "check/internal/story.hpp"
#include "check/internal/trial.hpp"
#include "check/measure_coverage.hpp"

namespace gloam::check {
namespace {

// A few inputs of all kinds: the beginning of a larger draw.
Domain::Inputs few_inputs(const Domain& domain, std::size_t count, std::uint64_t seed,
                          glm::ivec2 image_size) {
    constexpr std::size_t spread = 16;
    const Domain::Inputs many = domain.draw(spread * count, seed, image_size);
    Domain::Inputs few{.width = many.width};
    for (std::size_t i = 0; i < many.count(); i += spread) {
        const auto row = many.row(i);
        few.words.insert(few.words.end(), row.begin(), row.end());
        few.branch.push_back(many.branch[i]);
    }
    return few;
}

// Each input is compiled code, so the scenarios of a question share the number of inputs.
std::size_t constants_of_each(std::size_t scenarios) {
    constexpr std::size_t least = 8;
    return std::max(least, ConstantKernel::most_inputs / std::max<std::size_t>(scenarios, 1));
}

}  // namespace

Verdict verdict_of(const shader::Variant& variant, const Question& question) {
    const bool by_rules = variant.strict || variant.relaxed || question.only_rules || !question.reference;
    return by_rules ? Verdict::rules : Verdict::budget;
}

Answer run(const Lab& lab, const Question& question, const RunOptions& options) {
    const KernelCore kernel = lab.kernel(question.file, question.function, question.signature);
    const Verdict verdict = verdict_of(lab.options().variant, question);
    Answer answer = empty_answer(question, verdict);
    answer.variant = lab.options().variant.name;
    const bool constants = lab.options().variant.constants != shader::Variant::Constants::none;
    internal::for_each_scenario(
        question, options.inputs, [&](const ImageScenario& scenario, std::size_t share) {
            const internal::Trial trial(lab, question, kernel, scenario, options.seed, verdict);
            if (constants) {
                const ConstantKernel folded(lab, question.file, question.function, question.signature);
                const std::size_t count = constants_of_each(question.scenarios.size());
                trial.compare_constants(few_inputs(question.domain, count, trial.input_seed(), scenario.size),
                                        folded, answer);
            } else {
                const auto drawn = question.domain.draw(share, trial.input_seed(), scenario.size);
                trial.judge(trial.run(drawn, answer), answer);
            }
        });
    if (options.coverage) answer.coverage = measure_coverage(lab, question, options);
    internal::tell_story(lab, question, options.seed, answer);
    return answer;
}

}  // namespace gloam::check
