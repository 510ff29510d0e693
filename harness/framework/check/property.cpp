// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <optional>
#include <ostream>

#include "check/function.hpp"
#include "check/reproduction.hpp"

namespace gloam::check {
namespace {

// Runs a property on inputs of a function.
class Property {
  public:
    Property(const KernelCore& core, const HoldsFor& holds) : core_(core), holds_(holds) {}

    struct Failure {
        std::vector<Word> input;
        std::vector<Word> outputs;
    };

    // The first input for which it does not hold. `words`: one input after another.
    [[nodiscard]] std::optional<Failure> first_failure(std::span<const Word> words, std::size_t count) const {
        if (count == 0) return std::nullopt;
        const KernelCore::Result result = core_.run(words, count);
        for (std::size_t i = 0; i < count; ++i) {
            const auto input = words.subspan(i * core_.input_words(), core_.input_words());
            const auto outputs =
                std::span(result.outputs).subspan(i * core_.output_words(), core_.output_words());
            if (!holds_(input, outputs))
                return Failure{{input.begin(), input.end()}, {outputs.begin(), outputs.end()}};
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<Failure> simpler(const Question& question, const Failure& failure) const {
        std::vector<Word> words;
        const auto candidates = simpler_inputs(question, failure.input);
        for (const std::vector<Word>& candidate : candidates)
            words.insert(words.end(), candidate.begin(), candidate.end());
        return first_failure(words, candidates.size());
    }

  private:
    const KernelCore& core_;
    const HoldsFor& holds_;
};

}  // namespace

PropertyResult check_property(const KernelCore& core, const Question& question, const HoldsFor& holds,
                              const RunOptions& options) {
    const Property property(core, holds);
    const Domain::Inputs inputs = question.domain.draw(options.inputs, options.seed);
    PropertyResult result{.inputs = inputs.count(), .words = {}, .story = {}};
    std::optional<Property::Failure> failure = property.first_failure(inputs.words, inputs.count());
    if (!failure) return result;
    while (const auto simpler = property.simpler(question, *failure)) failure = simpler;
    result.words = failure->input;
    result.story =
        fmt::format("{} ({}): the property does not hold for {}, where the result is {}\n", question.function,
                    question.file, describe_inputs(question.signature, failure->input),
                    describe_outputs(question.signature, failure->outputs));
    return result;
}

std::ostream& operator<<(std::ostream& stream, const PropertyResult& result) {
    if (result.story.empty())
        return stream << fmt::format("the property holds for {} inputs\n", result.inputs);
    return stream << result.story;
}

}  // namespace gloam::check
