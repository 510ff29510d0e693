// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "check/domain.hpp"
#include "check/question.hpp"
#include "numeric/random.hpp"

namespace gloam::check::internal {

// The words of one in or inout parameter in an input.
struct Slot {
    const shader::Parameter* parameter;
    const Values* values;
    std::size_t first;
    std::size_t count;
};

// In the order of the parameters; without samplers, which have no words. The question must outlive them.
[[nodiscard]] std::vector<Slot> slots_of(const Question& question);

// Candidates of a search for a worst input: inputs drawn from a domain, and inputs a little beside the worst
// so far. All stay inside the domain.
class Moves {
  public:
    // Draws `drawn` inputs (at least 1), which candidates exchange parameters with. The domain of the
    // question must outlive this object.
    Moves(const Question& question, std::size_t drawn, glm::ivec2 image_size, std::uint64_t input_seed,
          std::uint64_t seed);

    [[nodiscard]] const Domain::Inputs& drawn() const { return drawn_; }  // before adjustment
    // Whether a candidate can differ from another.
    [[nodiscard]] bool possible() const { return !slots_.empty(); }

    // One to three changes of an input: a float moves by a power of two of steps, from a neighbour to several
    // binades away, or changes its sign; or a parameter takes its value in another drawn input.
    [[nodiscard]] std::vector<Word> moved(std::vector<Word> words);

    // A candidate from the pool, which is sorted, the worst first: those are chosen more often.
    template <class Candidate>
    [[nodiscard]] std::vector<Word> from_pool(const std::vector<Candidate>& pool) {
        if (pool.empty()) {
            const auto row = drawn_.row(random_.below(drawn_.count()));
            return {row.begin(), row.end()};
        }
        const double rank = random_.unit() * random_.unit();
        return moved(pool[static_cast<std::size_t>(rank * static_cast<double>(pool.size()))].words);
    }

    // Keeps the worst candidates, each once.
    template <class Candidate>
    static void keep_the_worst(std::vector<Candidate>& pool) {
        constexpr std::size_t most = 48;
        std::ranges::stable_sort(pool,
                                 [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
        const auto same = [](const Candidate& a, const Candidate& b) {
            return a.score == b.score && a.words == b.words;
        };
        pool.erase(std::unique(pool.begin(), pool.end(), same), pool.end());
        if (pool.size() > most) pool.resize(most);
    }

  private:
    void move(std::vector<Word>& words);
    Word moved_scalar(shader::Scalar scalar, Word word);

    numeric::Random random_;
    std::vector<shader::Scalar> scalars_;
    std::vector<Slot> slots_;
    Domain::Inputs drawn_;
};

}  // namespace gloam::check::internal
