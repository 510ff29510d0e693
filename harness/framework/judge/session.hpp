// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "judge/answer.hpp"
#include "judge/question.hpp"
#include "judge/run.hpp"
#include "subject/lab.hpp"

namespace gloam::judge {

// A question that is ready to evaluate inputs, with the images of one scenario: in memory, or as constants of
// the shader where the lab's variant says so. The lab and the question must outlive it.
class Session {
  public:
    // `seed` makes the images.
    Session(const subject::Lab& lab, const Question& question, subject::KernelCore kernel,
            subject::ImageScenario scenario, std::uint64_t seed);

    // Inputs as the device was given them, with what it made of them.
    struct Evaluated {
        subject::Domain::Inputs inputs;
        subject::KernelCore::Result result;
    };
    // Evaluates inputs, and notes an access outside an image in the answer; of constants also how many
    // results differ from those with the inputs in memory. On a device that need not keep the sign of zero,
    // +0 takes the place of -0. What is undefined for the interpreter, which stops there, gets words that no
    // function returns.
    [[nodiscard]] Evaluated run(subject::Domain::Inputs inputs, Answer& answer) const;

    // The inputs of a function without a reference that come to their end in a bounded number of instructions
    // of the interpreter; the others are counted in the answer, and no device gets them.
    [[nodiscard]] subject::Domain::Inputs without_long_runs(const subject::Domain::Inputs& inputs,
                                                            Answer& answer) const;

    // Judges what run() returned, and adds the results to the answer. `fractions`: as in judge::judge().
    void judge(const Evaluated& evaluated, Answer& answer, std::span<double> fractions = {}) const;

    // The first of these inputs that fails, with its outputs.
    [[nodiscard]] std::optional<Sample> first_failing(std::span<const std::vector<Word>> inputs) const;

    [[nodiscard]] const subject::ImageSet& images() const { return images_; }
    [[nodiscard]] const subject::KernelSource& source() const { return *kernel_.module().source; }

    // The seed of this scenario's inputs.
    [[nodiscard]] std::uint64_t input_seed() const { return input_seed_; }

  private:
    [[nodiscard]] std::vector<char> long_runs(const subject::Domain::Inputs& inputs,
                                              std::uint64_t limit) const;
    // One input after another.
    [[nodiscard]] subject::KernelCore::Result run_each(const subject::Domain::Inputs& inputs) const;
    // Every few inputs form a module of their own and cost one compilation.
    [[nodiscard]] subject::KernelCore::Result run_constants(const subject::Domain::Inputs& inputs) const;

    const subject::Lab& lab_;
    const Question& question_;
    subject::KernelCore kernel_;
    bool has_constants_;  // the inputs are constants of the kernels
    subject::ImageScenario scenario_;
    std::uint64_t input_seed_;
    subject::ImageSet images_;
    JudgeOptions options_;
};

// The most inputs as constants in one run.
inline constexpr std::size_t most_constants = 64;

// The domain of a question, and the numbers of its function's module (Domain::and_numbers): what it compares
// with is an input. Throws source::CompileError.
[[nodiscard]] subject::Domain domain_of(const subject::Lab& lab, const Question& question,
                                        const subject::KernelSource& source);

// The seed of a scenario's inputs in a run with seed `seed`.
[[nodiscard]] std::uint64_t input_seed_of(const Question& question, const subject::ImageScenario& scenario,
                                          std::uint64_t seed);

// The images of a scenario in a run with seed `seed`; empty for a scenario without images.
[[nodiscard]] subject::ImageSet images_of(const subject::ImageScenario& scenario, std::uint64_t seed);

// Gives an answer to which all sessions have added its variant and, of a failure, its story: what was found,
// and the worst input operation by operation. `given`: the module of the function's kernel.
void complete(Answer& answer, const subject::Lab& lab, const Question& question,
              const subject::KernelModule& given, std::uint64_t seed);

}  // namespace gloam::judge
