// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "effect/errors.hpp"
#include "gpu/image.hpp"

namespace gloam::effect {

// Structural similarity (SSIM: Wang et al. 2004) of an occlusion image and the truth, as visibility on [0,
// 1]: a Gaussian window of 11 x 11 pixels and 1.5 pixels deviation, constants 0.01^2 and 0.03^2. Windows hold
// only pixels whose truth is known, and the mean is over those. 1 for equal images, and when no truth is
// known. Throws std::invalid_argument when the sizes disagree.
[[nodiscard]] double structural_similarity(std::span<const float> occlusion, std::span<const float> truth,
                                           gpu::Extent extent);

}  // namespace gloam::effect
