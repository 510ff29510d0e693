// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace gloam::numeric {

// Structural similarity (SSIM: Wang et al. 2004) of an image and the truth, with values in [0, 1]. The window
// is a Gaussian of 11 x 11 pixels with a standard deviation of 1.5 pixels; the constants are 0.01^2 and
// 0.03^2. Only pixels with a finite truth count, in a window and in the mean. Returns 1 for equal images, and
// when no truth is known. Throws std::invalid_argument when the sizes disagree.
[[nodiscard]] double structural_similarity(std::span<const double> image, std::span<const double> truth,
                                           std::size_t width, std::size_t height);

}  // namespace gloam::numeric
