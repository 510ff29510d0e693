// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <ostream>
#include <set>
#include <stdexcept>

#include "judge/function.hpp"
#include "judge/reproduction.hpp"

namespace gloam::judge {
namespace {

using namespace subject;

using module::Scalar;
using Words = std::vector<Word>;

constexpr int significand_bits = 23;
constexpr Word sign_bit = 0x80000000U;

std::size_t float_complexity(Word word) {
    const Word magnitude = word & ~sign_bit;
    const std::size_t sign = word == magnitude ? 0 : 1;
    if (magnitude == 0) return sign;
    constexpr int bias = 127;
    const int exponent = static_cast<int>(magnitude >> significand_bits) - bias;
    if (exponent > bias) return 2000 + sign;  // infinity or NaN: more complex than any number
    const Word significand = magnitude & ((Word{1} << significand_bits) - 1U);
    const int bits = significand == 0 ? 0 : significand_bits - std::countr_zero(significand);
    return 2 + sign + 2 * static_cast<std::size_t>(bits) + static_cast<std::size_t>(std::abs(exponent));
}

bool is_negative(Word word, Scalar scalar) {
    return scalar == Scalar::int_ && (word & sign_bit) != 0;
}

std::size_t scalar_complexity(Word word, Scalar scalar) {
    if (module::is_float(scalar)) return float_complexity(word);
    const bool negative = is_negative(word, scalar);
    const Word magnitude = negative ? 0U - word : word;
    // By bit width, then by the number of set bits: 4 is simpler than 5, and 3 is simpler than both.
    return (negative ? 1U : 0U) + static_cast<std::size_t>(4 * std::bit_width(magnitude)) +
           static_cast<std::size_t>(std::popcount(magnitude));
}

void add_float_candidates(Word word, Scalar scalar, std::set<Word>& candidates) {
    const auto value = from_word<double>(word);
    const auto add = [&](double number) { candidates.insert(float_word(scalar, number)); };
    for (const double simple : {0.0, 1.0, -1.0, 0.5, -0.5, 2.0, -2.0, 3.0, 0.25, 4.0, 10.0, 100.0})
        add(simple);
    candidates.insert(word ^ sign_bit);
    if (!std::isfinite(value)) return;
    for (int kept = 0; kept < significand_bits; ++kept) {
        const Word step = Word{1} << (significand_bits - kept);
        candidates.insert(word & ~(step - 1U));                // towards zero
        candidates.insert((word + step - 1U) & ~(step - 1U));  // away from zero
    }
    add(std::trunc(value));
    const int exponent = value == 0.0 ? 0 : std::ilogb(value);
    for (int step = std::abs(exponent); step > 0; step /= 2)
        add(std::ldexp(value, exponent > 0 ? -step : step));
    if (exponent != 0) add(std::ldexp(value, exponent > 0 ? -1 : 1));
}

void add_integer_candidates(Word word, Scalar scalar, std::set<Word>& candidates) {
    if (scalar == Scalar::bool_) {
        candidates.insert(0U);
        return;
    }
    for (Word simple = 0; simple <= 8; ++simple) candidates.insert(simple);
    const bool negative = is_negative(word, scalar);
    const Word magnitude = negative ? 0U - word : word;
    const auto add = [&](Word smaller) { candidates.insert(negative ? 0U - smaller : smaller); };
    if (negative) candidates.insert(magnitude);
    for (unsigned shift = 1; shift < module::bits_of(scalar); ++shift) {
        add(magnitude >> shift);
        add(magnitude & ~((Word{1} << shift) - 1U));
        add(magnitude - (magnitude >> shift));
    }
    if (magnitude > 0) add(magnitude - 1U);
}

// The distance of an input from the simplest one, 0 for all zeros. A word that is one costs little. Other
// floats cost by the bits of their significand and by the distance of their exponent from that of 1; integers
// cost by their bits.
std::size_t complexity(std::span<const Word> input, const std::vector<Scalar>& scalars) {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < input.size(); ++i) sum += scalar_complexity(input[i], scalars[i]);
    return sum;
}

// Inputs of the domain that are simpler than this one, the simplest first. Values are changed one at a time;
// equal values are also changed together.
std::vector<Words> simpler_inputs(const Question& question, const Words& input) {
    const std::vector<Scalar> scalars = question.signature.input_scalars();
    std::set<Words> found;
    for (std::size_t i = 0; i < input.size(); ++i) {
        const Scalar scalar = scalars[i];
        std::set<Word> candidates;
        if (module::is_float(scalar)) {
            add_float_candidates(input[i], scalar, candidates);
        } else {
            add_integer_candidates(input[i], scalar, candidates);
        }
        for (const Word candidate : candidates) {
            Words alone = input;
            alone[i] = candidate;
            found.insert(std::move(alone));
            Words together = input;
            for (std::size_t j = 0; j < input.size(); ++j)
                if (scalars[j] == scalar && input[j] == input[i]) together[j] = candidate;
            found.insert(std::move(together));
        }
    }
    const std::size_t now = complexity(input, scalars);
    std::vector<Words> simpler;
    for (const Words& words : found)
        if (complexity(words, scalars) < now && question.domain.holds(words, input)) simpler.push_back(words);
    std::ranges::stable_sort(simpler, {}, [&](const Words& words) { return complexity(words, scalars); });
    return simpler;
}

}  // namespace

Sample shrink(const Question& question, const Sample& failing, const FirstFailing& first_failing) {
    std::optional<Sample> best = first_failing(std::vector<Words>{failing.inputs});
    if (!best) throw std::invalid_argument("shrink: the input does not fail: there is nothing to shrink");
    while (const auto simpler = first_failing(simpler_inputs(question, best->inputs))) best = simpler;
    best->scenario = failing.scenario;
    best->index = failing.index;
    return *best;
}

PropertyResult check_property(const KernelCore& core, const Question& question, const HoldsFor& holds,
                              const RunOptions& options) {
    const std::size_t width = core.output_words();
    const auto first_failing = [&](std::span<const std::vector<Word>> inputs) -> std::optional<Sample> {
        Domain::Inputs all;
        for (const std::vector<Word>& input : inputs) all.add(input);
        const KernelCore::Result result = core.run(all.words, all.count());
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

}  // namespace gloam::judge
