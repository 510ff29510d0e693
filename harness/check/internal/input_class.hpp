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

}  // namespace gloam::check::internal
