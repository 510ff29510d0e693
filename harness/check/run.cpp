// SPDX-License-Identifier: MIT
#include "check/run.hpp"

#include <algorithm>

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

// The inputs with another one in place of those at `endless`, if any other is left.
Domain::Inputs ended(Domain::Inputs inputs, const std::vector<std::size_t>& endless) {
    std::size_t other = 0;
    while (std::ranges::find(endless, other) != endless.end()) ++other;
    if (other >= inputs.count()) return inputs;
    for (const std::size_t i : endless)
        std::ranges::copy(inputs.row(other),
                          inputs.words.begin() + static_cast<std::ptrdiff_t>(i * inputs.width));
    return inputs;
}

// llvmpipe ends all loops of a group of invocations when one of them does not end (after 65,536 iterations),
// so inputs that failed beside such a one are run again without it.
void judge(const internal::Trial& trial, const Domain::Inputs& inputs, Answer& answer) {
    internal::Trial::Evaluated evaluated = trial.run(inputs, answer);
    Answer judged = empty_answer({}, answer.verdict);
    trial.judge(evaluated, judged);
    if (!judged.endless.empty() && judged.outside() > 0) {
        evaluated.result = trial.run(ended(evaluated.inputs, judged.endless), answer).result;
        judged = empty_answer({}, answer.verdict);
        trial.judge(evaluated, judged);
    }
    answer.merge(judged);
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
                judge(trial, question.domain.draw(share, trial.input_seed(), scenario.size), answer);
            }
        });
    if (options.coverage) answer.coverage = measure_coverage(lab, question, options);
    internal::tell_story(lab, question, options.seed, answer);
    return answer;
}

}  // namespace gloam::check
