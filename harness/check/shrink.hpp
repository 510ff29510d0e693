// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "check/judge.hpp"
#include "check/kernel_core.hpp"

namespace gloam::check {

// Evaluates `count` inputs: a kernel, usually.
using Evaluate = std::function<KernelCore::Result(std::span<const Word> inputs, std::size_t count)>;

// What shrinking needs to know of a check.
struct ShrinkScope {
    const Question& question;
    const JudgeOptions& options;
    const ImageSet& images;
    Evaluate evaluate;
    std::size_t at_once = std::size_t{1} << 20U;  // inputs that are best evaluated together
};

// How far an input is from the simplest of all, 0: zeros cost nothing, ones little, floats by the bits of
// their significand and the distance of their exponent from that of 1, integers by their bits.
[[nodiscard]] std::size_t complexity(std::span<const Word> input, const std::vector<shader::Scalar>& scalars);

// The simplest input of the domain that is found to fail as `failing` does: outside what is allowed.
// Values are changed one at a time, values that are equal also together; the simplest change that still fails
// is kept, until none does. The same for the same input. Throws std::invalid_argument when `failing` does not
// fail.
[[nodiscard]] Sample shrink(const ShrinkScope& scope, const Sample& failing);

}  // namespace gloam::check
