// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <optional>
#include <ostream>

#include "check/function.hpp"
#include "check/reproduction.hpp"

namespace gloam::check {

PropertyResult check_property(const KernelCore& core, const Question& question, const HoldsFor& holds,
                              const RunOptions& options) {
    const std::size_t width = core.output_words();
    const auto first_failing = [&](std::span<const std::vector<Word>> inputs) -> std::optional<Sample> {
        std::vector<Word> words;
        for (const std::vector<Word>& input : inputs) words.insert(words.end(), input.begin(), input.end());
        const KernelCore::Result result = core.run(words, inputs.size());
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const auto outputs = std::span(result.outputs).subspan(i * width, width);
            if (!holds(inputs[i], outputs))
                return Sample{.inputs = inputs[i], .got = {outputs.begin(), outputs.end()}};
        }
        return std::nullopt;
    };
    const Domain::Inputs drawn = question.domain.draw(options.inputs, options.seed);
    std::vector<std::vector<Word>> inputs;
    for (std::size_t i = 0; i < drawn.count(); ++i)
        inputs.emplace_back(drawn.row(i).begin(), drawn.row(i).end());
    PropertyResult result{.inputs = inputs.size(), .words = {}, .story = {}};
    const std::optional<Sample> failing = first_failing(inputs);
    if (!failing) return result;
    const Sample simplest = shrink(question, *failing, first_failing);
    result.words = simplest.inputs;
    result.story =
        fmt::format("{} ({}): the property does not hold for {}, where the result is {}\n", question.function,
                    question.file, describe_inputs(question.signature, simplest.inputs),
                    describe_outputs(question.signature, simplest.got));
    return result;
}

std::ostream& operator<<(std::ostream& stream, const PropertyResult& result) {
    if (result.story.empty())
        return stream << fmt::format("the property holds for {} inputs\n", result.inputs);
    return stream << result.story;
}

}  // namespace gloam::check
