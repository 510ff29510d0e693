// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "check/judge.hpp"
#include "check/kernel_core.hpp"

namespace gloam::check {

// Evaluates `count` inputs; usually a kernel.
using Evaluate = std::function<KernelCore::Result(std::span<const Word> inputs, std::size_t count)>;

// The parts of a check that shrinking needs.
struct ShrinkScope {
    const Question& question;
    const JudgeOptions& options;
    const ImageSet& images;
    Evaluate evaluate;
    std::size_t at_once = std::size_t{1} << 20U;  // inputs to evaluate together
};

// The distance of an input from the simplest one, 0 for all zeros. A word that is one costs little. Other
// floats cost by the bits of their significand and by the distance of their exponent from that of 1; integers
// cost by their bits.
[[nodiscard]] std::size_t complexity(std::span<const Word> input, const std::vector<shader::Scalar>& scalars);

// The simplest input of the domain that is found to fail like `failing`: outside what is allowed. Values are
// changed one at a time; equal values are also changed together. The simplest change that still fails is
// kept, until no change does. The result is deterministic. Throws std::invalid_argument if `failing` does not
// fail.
[[nodiscard]] Sample shrink(const ShrinkScope& scope, const Sample& failing);

}  // namespace gloam::check
