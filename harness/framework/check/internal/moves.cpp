// SPDX-License-Identifier: MIT
#include "check/internal/moves.hpp"

#include <algorithm>

#include "numeric/numbers.hpp"

namespace gloam::check::internal {
namespace {

constexpr int most_moves = 3;  // of one input at once
constexpr int tries = 4;       // attempts to find a move that stays inside the domain

}  // namespace

std::vector<Slot> slots_of(const Question& question) {
    std::vector<Slot> slots;
    std::size_t first = 0;
    std::size_t at = 0;
    for (const shader::Parameter& parameter : question.signature.parameters) {
        if (parameter.direction == shader::Direction::out) continue;
        const std::size_t count = scalars_of(parameter.type).size();
        const Values& values = question.domain.parameters().at(at++);
        if (count > 0) slots.push_back({&parameter, &values, first, count});
        first += count;
    }
    return slots;
}

Moves::Moves(const Question& question, std::size_t drawn, glm::ivec2 image_size, std::uint64_t input_seed,
             std::uint64_t seed)
    : random_(seed),
      scalars_(question.signature.input_scalars()),
      slots_(slots_of(question)),
      drawn_(question.domain.draw_unadjusted(drawn, input_seed, image_size)) {}

std::vector<Word> Moves::moved(std::vector<Word> words) {
    const auto moves = 1 + static_cast<int>(random_.below(most_moves));
    for (int i = 0; i < moves; ++i) move(words);
    return words;
}

void Moves::move(std::vector<Word>& words) {
    const Slot& slot = slots_[random_.below(slots_.size())];
    const auto at = static_cast<std::ptrdiff_t>(slot.first);
    const auto count = static_cast<std::ptrdiff_t>(slot.count);
    for (int i = 0; i < tries; ++i) {
        std::vector<Word> value(words.begin() + at, words.begin() + at + count);
        if (random_.below(4) == 0) {
            const auto other = drawn_.row(random_.below(drawn_.count())).subspan(slot.first, slot.count);
            value.assign(other.begin(), other.end());
        } else {
            const std::size_t word = random_.below(slot.count);
            value[word] = moved_scalar(scalars_[slot.first + word], value[word]);
            if (!slot.values->admits(value)) continue;
        }
        std::ranges::copy(value, words.begin() + at);
        return;
    }
}

Word Moves::moved_scalar(shader::Scalar scalar, Word word) {
    const bool down = random_.below(2) == 0;
    const unsigned bits = shader::bits_of(scalar);
    const std::int64_t distance = std::int64_t{1} << random_.below(bits * 13 / 16);
    if (scalar == shader::Scalar::bool_) return 1U - word;
    if (!shader::is_float(scalar)) return word + static_cast<Word>(down ? -distance : distance);
    if (random_.below(32) == 0) return word ^ 0x80000000U;
    return stepped_float(scalar, word, down ? -distance : distance);
}

}  // namespace gloam::check::internal
