// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "judge/question.hpp"
#include "numeric/random.hpp"
#include "subject/domain.hpp"

namespace gloam::audit::internal {

// The words of one in or inout parameter in an input, and the values that they may have.
struct Slot : subject::InputSlot {
    const subject::Values* values;
};

// In the order of the parameters; without samplers, which have no words. The question must outlive them.
[[nodiscard]] std::vector<Slot> slots_of(const judge::Question& question);

// Candidates of a search for a worst input: inputs drawn from a domain, and inputs a little beside the worst
// so far. All stay inside the domain.
class Moves {
  public:
    // Draws `drawn` inputs (at least 1), which candidates exchange parameters with. The domain of the
    // question must outlive this object.
    Moves(const judge::Question& question, std::size_t drawn, glm::ivec2 image_size, std::uint64_t input_seed,
          std::uint64_t seed);

    [[nodiscard]] const subject::Domain::Inputs& drawn() const { return drawn_; }  // before adjustment

    // An input and how bad it is.
    struct Candidate {
        std::vector<subject::Word> words;  // as drawn, before adjustment
        double score = 0.0;
    };

    // Adds those of a positive score to the pool, which keeps the worst, each once, the worst first.
    static void add(std::vector<Candidate> candidates, std::vector<Candidate>& pool);
    static void keep_the_worst(std::vector<Candidate>& pool);

    // Runs so many candidates beside the worst of the pool, where those are chosen more often, a generation
    // at a time, as long as it goes on; none where no candidate can differ from another. `run` sets their
    // scores.
    void climb(std::vector<Candidate>& pool, std::size_t inputs, std::size_t generation,
               const std::function<void(std::vector<Candidate>&)>& run, const std::function<bool()>& goes_on);

  private:
    [[nodiscard]] std::vector<subject::Word> from_pool(const std::vector<Candidate>& pool);
    // A change of an input: a float moves by a power of two of steps, from a neighbour to several binades
    // away, or changes its sign; or a parameter takes its value in another drawn input.
    void move(std::vector<subject::Word>& words);
    subject::Word moved_scalar(module::Scalar scalar, subject::Word word);

    numeric::Random random_;
    std::vector<module::Scalar> scalars_;
    std::vector<Slot> slots_;
    subject::Domain::Inputs drawn_;
};

}  // namespace gloam::audit::internal
