// SPDX-License-Identifier: MIT
#include "check/internal/story.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

#include "check/describe.hpp"
#include "check/explain.hpp"
#include "check/internal/trial.hpp"

namespace gloam::check::internal {
namespace {

constexpr std::size_t most_lines = 16;

ImageSet images_behind(const Question& question, const Sample& sample, std::uint64_t seed) {
    const auto found = std::ranges::find(question.scenarios, sample.scenario, &ImageScenario::name);
    return found == question.scenarios.end() ? ImageSet{} : images_of(*found, seed);
}

std::string explanation_of(const Lab& lab, const Question& question, const Sample& sample,
                           std::uint64_t seed) {
    try {
        const KernelSource source = lab.source(question.file, question.function, question.signature);
        return "  the worst input, operation by operation, rounded correctly:\n" +
               to_text(explain(lab.compile_options(), source, sample.inputs,
                               images_behind(question, sample, seed)),
                       most_lines);
    } catch (const std::exception& error) {  // a shader that the interpreter cannot run still gets a story
        return fmt::format("  the worst input cannot be explained: {}\n", error.what());
    }
}

}  // namespace

void tell_story(const Lab& lab, const Question& question, std::uint64_t seed, Answer& answer) {
    if (!answer.failed()) return;
    answer.story = describe(question.signature, answer);
    if (answer.outside() > 0 && answer.worst)
        answer.story += explanation_of(lab, question, *answer.worst, seed);
}

}  // namespace gloam::check::internal
