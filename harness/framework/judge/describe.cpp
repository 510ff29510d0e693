// SPDX-License-Identifier: MIT
// What an answer says of its inputs.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <cmath>
#include <ostream>

#include "judge/answer.hpp"
#include "numeric/numbers.hpp"

namespace gloam::judge {
namespace {

using namespace subject;

using module::Scalar;

// The text of each value, as text(scalars, i, value) has it.
template <class AllValues, class Text>
std::string listed(const std::vector<Scalar>& scalars, const AllValues& values, const Text& text) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < values.size(); ++i) texts.push_back(text(scalars, i, values[i]));
    return fmt::format("{}", fmt::join(texts, ", "));
}

std::string words_text(const std::vector<Scalar>& scalars, std::span<const Word> words) {
    return listed(scalars, words,
                  [](const auto& all, std::size_t i, Word word) { return subject::text_of(all[i], word); });
}

// The text of the number of a word. An integer in decimal; the bits of its value as a double would carry no
// information.
std::string number_text(const std::vector<Scalar>& scalars, std::size_t i, double number) {
    constexpr double exact = 9'007'199'254'740'992.0;
    const Scalar scalar = i < scalars.size() ? scalars[i] : Scalar::float_;
    const bool whole = std::abs(number) <= exact && number == std::floor(number);
    return module::is_float(scalar) || !whole ? numeric::to_text(number) : fmt::format("{:.0f}", number);
}

std::string bounds_text(const std::vector<Scalar>& scalars, std::size_t i, const numeric::Bounds& bounds) {
    const std::string low = number_text(scalars, i, bounds.low);
    const std::string high = number_text(scalars, i, bounds.high);
    if (bounds.empty()) return "nothing but NaN";
    return (low == high ? low : fmt::format("[{}, {}]", low, high)) + (bounds.nan ? " or NaN" : "");
}

// A line with every outcome; empty if there are none.
std::string permitted_text(const std::vector<Scalar>& scalars, const std::vector<Sample::Outcome>& outcomes) {
    std::vector<std::string> texts;
    for (const Sample::Outcome& outcome : outcomes) texts.push_back(listed(scalars, outcome, bounds_text));
    return texts.empty() ? "" : fmt::format("    permitted {}\n", fmt::join(texts, "; or "));
}

std::string sample_text(const Signature& signature, const Sample& sample) {
    return fmt::format("input {} ({}{}{}): {}\n    got  {}\n    want {}\n{}    error {}\n", sample.index,
                       name_of(sample.input_class), sample.scenario.empty() ? "" : ", images ",
                       sample.scenario, sample.values, words_text(signature.output_scalars(), sample.got),
                       listed(signature.output_scalars(), sample.want, number_text),
                       permitted_text(signature.output_scalars(), sample.permitted_outcomes()),
                       error_text(sample));
}

}  // namespace

std::string describe_inputs(const Signature& signature, const std::vector<Word>& inputs) {
    std::vector<std::string> texts;
    for (const auto& [parameter, first, count] : signature.inputs()) {
        if (count == 0) continue;
        const std::string values =
            words_text(scalars_of(parameter->type), std::span(inputs).subspan(first, count));
        const std::string what =
            module::to_glsl(parameter->type) + (parameter->global ? " " + parameter->name : "");
        texts.push_back(fmt::format(fmt::runtime(count > 1 ? "{} ({})" : "{} {}"), what, values));
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

std::string describe_outputs(const Signature& signature, const std::vector<Word>& outputs) {
    return words_text(signature.output_scalars(), outputs);
}

std::string describe(const Signature& signature, const Answer& answer) {
    const std::string limit =
        answer.rules_alone() ? "what Vulkan's precision rules permit" : to_text(answer.budget);
    std::string text = answer.must_hold && answer.forbidden == 0
                           ? fmt::format("{} ({}) must hold, and is false for {} of {} inputs\n",
                                         answer.function, answer.file, answer.outside(), answer.inputs())
                           : fmt::format("{} ({}): {} of {} inputs outside {}\n", answer.function,
                                         answer.file, answer.outside(), answer.inputs(), limit);
    if (!answer.fault.empty()) text += fmt::format("  {}\n", answer.fault);
    for (std::size_t i = 0; i < input_class_count; ++i) {
        const ClassCount& count = answer.classes[i];
        if (count.inputs == 0) continue;
        text += fmt::format("  {:<10} {:>9} inputs {:>9} outside", name_of(static_cast<InputClass>(i)),
                            count.inputs, count.outside);
        if (count.recorded > 0) text += fmt::format(" {:>9} only recorded", count.recorded);
        if (count.open > 0) text += fmt::format(" {:>9} open", count.open);
        text += "\n";
    }
    if (answer.worst) text += "  worst " + sample_text(signature, *answer.worst);
    for (const auto& first : answer.first_outside) {
        if (first && (!answer.worst || first->index != answer.worst->index))
            text += "  first " + sample_text(signature, *first);
    }
    return text;
}

void describe_samples(const Signature& signature, Answer& answer) {
    const auto describe_one = [&signature](std::optional<Sample>& sample) {
        if (sample && sample->values.empty()) sample->values = describe_inputs(signature, sample->inputs);
    };
    describe_one(answer.worst);
    describe_one(answer.first_unbounded);
    for (std::optional<Sample>& first : answer.first_outside) describe_one(first);
}

std::ostream& operator<<(std::ostream& stream, const Answer& answer) {
    if (!answer.story.empty()) return stream << answer.story;
    const std::string why = answer.ran() ? answer.not_judged_because() : answer.error;
    return stream << fmt::format("{} ({}): {} of {} inputs outside{}{}\n", answer.function, answer.file,
                                 answer.outside(), answer.inputs(), why.empty() ? "" : ": ", why);
}

}  // namespace gloam::judge
