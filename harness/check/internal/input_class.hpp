// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "check/answer.hpp"

namespace gloam::check::internal {

// The class of an input. `branch`: it was placed at a branch point.
[[nodiscard]] InputClass class_of(std::span<const Word> inputs, const std::vector<shader::Scalar>& scalars,
                                  bool branch);

// Whether an input or its exact result contains NaN, infinity or -0, which some devices do not preserve.
[[nodiscard]] bool holds_special(const Sample& sample, const std::vector<shader::Scalar>& scalars);

// Makes +0 of every -0, for a device that need not keep its sign: so the kernel and the reference get the
// same input, and it can be judged. `words`: one input after another.
void set_positive_zeros(std::span<Word> words, const std::vector<shader::Scalar>& scalars);

}  // namespace gloam::check::internal
