// SPDX-License-Identifier: MIT
#include "check/describe.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <ostream>

#include "numeric/text.hpp"

namespace gloam::check {
namespace {

using shader::Scalar;

std::string scalar_text(Scalar scalar, Word word) {
    switch (scalar) {
        case Scalar::float_:
            return numeric::to_text(from_word<float>(word));
        case Scalar::int_:
            return fmt::format("{}", from_word<int>(word));
        case Scalar::bool_:
            return word != 0U ? "true" : "false";
        default:
            return fmt::format("{} (0x{:08x})", word, word);
    }
}

std::string words_text(const std::vector<Scalar>& scalars, const std::vector<Word>& words) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < words.size(); ++i) texts.push_back(scalar_text(scalars[i], words[i]));
    return fmt::format("{}", fmt::join(texts, ", "));
}

// An integer in decimal; the bits of its value as a double would carry no information.
std::string number_text(Scalar scalar, double number) {
    constexpr double exact = 9'007'199'254'740'992.0;
    const bool whole = std::abs(number) <= exact && number == std::floor(number);
    return scalar == Scalar::float_ || !whole ? numeric::to_text(number) : fmt::format("{:.0f}", number);
}

std::string numbers_text(const std::vector<Scalar>& scalars, const std::vector<double>& numbers) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        texts.push_back(number_text(i < scalars.size() ? scalars[i] : Scalar::float_, numbers[i]));
    return fmt::format("{}", fmt::join(texts, ", "));
}

// The bounds of each output; empty if there are none.
std::string permitted_text(const std::vector<Scalar>& scalars,
                           const std::vector<numeric::Bounds>& permitted) {
    if (permitted.empty()) return {};
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < permitted.size(); ++i) {
        const numeric::Bounds& bounds = permitted[i];
        const Scalar scalar = i < scalars.size() ? scalars[i] : Scalar::float_;
        const std::string range = bounds.empty() ? std::string("nothing but NaN")
                                                 : fmt::format("[{}, {}]", number_text(scalar, bounds.low),
                                                               number_text(scalar, bounds.high));
        texts.push_back(bounds.nan && !bounds.empty() ? range + " or NaN" : range);
    }
    return fmt::format("    permitted {}\n", fmt::join(texts, ", "));
}

std::string sample_text(const Signature& signature, const Sample& sample) {
    return fmt::format(
        "input {} ({}{}{}): {}\n    got  {}\n    want {}\n{}    error {:.6g} ulp, {:.6g} absolute\n",
        sample.index, name_of(sample.input_class), sample.scenario.empty() ? "" : ", images ",
        sample.scenario, sample.values, words_text(signature.output_scalars(), sample.got),
        numbers_text(signature.output_scalars(), sample.want),
        permitted_text(signature.output_scalars(), sample.permitted), sample.ulp, sample.absolute);
}

}  // namespace

std::string describe_inputs(const Signature& signature, const std::vector<Word>& inputs) {
    std::vector<std::string> texts;
    std::size_t first = 0;
    for (const shader::Parameter& p : signature.parameters) {
        if (p.direction == shader::Direction::out) continue;
        const std::vector<Scalar> scalars = scalars_of(p.type);
        const std::vector<Word> words(inputs.begin() + static_cast<std::ptrdiff_t>(first),
                                      inputs.begin() + static_cast<std::ptrdiff_t>(first + scalars.size()));
        const std::string values = words_text(scalars, words);
        texts.push_back(fmt::format(fmt::runtime(scalars.size() > 1 ? "{} ({})" : "{} {}"),
                                    shader::to_glsl(p.type), values));
        first += scalars.size();
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

std::string describe(const Signature& signature, const Answer& answer) {
    const std::string limit =
        answer.verdict == Verdict::rules ? "what Vulkan's precision rules permit" : to_text(answer.budget);
    std::string text = fmt::format("{} ({}): {} of {} inputs outside {}\n", answer.function, answer.file,
                                   answer.outside(), answer.inputs(), limit);
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

}  // namespace gloam::check
