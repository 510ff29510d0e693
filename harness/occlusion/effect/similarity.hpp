// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "effect/errors.hpp"
#include "gpu/resources.hpp"

namespace gloam::effect {

// Structural similarity (SSIM: Wang et al. 2004) of an occlusion image and the truth, as visibility in [0,
// 1]. The window is a Gaussian of 11 x 11 pixels with a standard deviation of 1.5 pixels; the constants are
// 0.01^2 and 0.03^2. Only pixels with known truth count, in a window and in the mean. Returns 1 for equal
// images, and when no truth is known. Throws std::invalid_argument when the sizes disagree.
[[nodiscard]] double structural_similarity(std::span<const float> occlusion, std::span<const float> truth,
                                           gpu::Extent extent);

}  // namespace gloam::effect
