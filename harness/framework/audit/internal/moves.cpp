// SPDX-License-Identifier: MIT
#include "audit/internal/moves.hpp"

#include <algorithm>

#include "numeric/numbers.hpp"

namespace gloam::audit::internal {

std::vector<Slot> slots_of(const judge::Question& question) {
    std::vector<Slot> slots;
    std::size_t at = 0;
    for (const subject::InputSlot& slot : question.signature.inputs()) {
        const subject::Values& values = question.domain.parameters().at(at++);
        if (slot.count > 0) slots.push_back({slot, &values});
    }
    return slots;
}

Moves::Moves(const judge::Question& question, std::size_t drawn, glm::ivec2 image_size,
             std::uint64_t input_seed, std::uint64_t seed)
    : random_(seed),
      scalars_(question.signature.input_scalars()),
      slots_(slots_of(question)),
      drawn_(question.domain.draw_unadjusted(drawn, input_seed, image_size)) {}

void Moves::add(std::vector<Candidate> candidates, std::vector<Candidate>& pool) {
    for (Candidate& candidate : candidates)
        if (candidate.score > 0.0) pool.push_back(std::move(candidate));
    keep_the_worst(pool);
}

void Moves::keep_the_worst(std::vector<Candidate>& pool) {
    constexpr std::size_t most = 48;
    std::ranges::stable_sort(pool, std::greater<>(), &Candidate::score);
    const auto same = std::ranges::unique(pool, [](const Candidate& a, const Candidate& b) {
        return a.score == b.score && a.words == b.words;
    });
    pool.erase(same.begin(), same.end());
    if (pool.size() > most) pool.resize(most);
}

void Moves::climb(std::vector<Candidate>& pool, std::size_t inputs, std::size_t generation,
                  const std::function<void(std::vector<Candidate>&)>& run,
                  const std::function<bool()>& goes_on) {
    for (std::size_t done = 0; !slots_.empty() && done < inputs && goes_on(); done += generation) {
        std::vector<Candidate> next(std::min(generation, inputs - done));
        for (Candidate& candidate : next) candidate.words = from_pool(pool);
        run(next);
        add(std::move(next), pool);
    }
}

std::vector<subject::Word> Moves::from_pool(const std::vector<Candidate>& pool) {
    if (pool.empty()) {
        const auto row = drawn_.row(random_.below(drawn_.count()));
        return {row.begin(), row.end()};
    }
    constexpr std::uint64_t most_moves = 3;
    const double rank = random_.unit() * random_.unit();
    std::vector<subject::Word> words =
        pool[static_cast<std::size_t>(rank * static_cast<double>(pool.size()))].words;
    for (std::uint64_t moves = 1 + random_.below(most_moves); moves > 0; --moves) move(words);
    return words;
}

void Moves::move(std::vector<subject::Word>& words) {
    const Slot& slot = slots_[random_.below(slots_.size())];
    const auto at = static_cast<std::ptrdiff_t>(slot.first);
    const auto count = static_cast<std::ptrdiff_t>(slot.count);
    constexpr int tries = 4;  // to find a move that stays inside the domain
    for (int i = 0; i < tries; ++i) {
        std::vector<subject::Word> value(words.begin() + at, words.begin() + at + count);
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

subject::Word Moves::moved_scalar(module::Scalar scalar, subject::Word word) {
    const bool down = random_.below(2) == 0;
    const unsigned bits = module::bits_of(scalar);
    const std::int64_t distance = std::int64_t{1} << random_.below(bits * 13 / 16);
    if (scalar == module::Scalar::bool_) return 1U - word;
    if (!module::is_float(scalar)) return word + static_cast<subject::Word>(down ? -distance : distance);
    if (random_.below(32) == 0) return word ^ 0x80000000U;
    return subject::stepped_float(scalar, word, down ? -distance : distance);
}

}  // namespace gloam::audit::internal
