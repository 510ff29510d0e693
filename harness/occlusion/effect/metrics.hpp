// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>

#include "effect/errors.hpp"
#include "effect/pixel_classes.hpp"
#include "effect/remap_fit.hpp"
#include "gpu/resources.hpp"

namespace gloam::effect {

// Differences between an occlusion image and the truth, over the pixels whose truth is known.
struct Metrics {
    Errors raw;
    double similarity = 1.0;  // SSIM
    Remap remap;              // the one that brings the image nearest to the truth
    Errors after_remap;
    double similarity_after_remap = 1.0;
};

// Calculates them. Throws std::invalid_argument when the sizes disagree.
[[nodiscard]] Metrics metrics_of(std::span<const float> occlusion, std::span<const float> truth,
                                 gpu::Extent extent);

// The truth where the mask is set, NaN elsewhere. Throws std::invalid_argument when the sizes disagree.
[[nodiscard]] Truth masked(std::span<const float> truth, const Mask& mask);

// Errors by class of pixel.
struct ClassErrors {
    Errors disoccluded;
    Errors near_moving;
    Errors settled;
};
[[nodiscard]] ClassErrors class_errors_of(std::span<const float> occlusion, std::span<const float> truth,
                                          const PixelClasses& classes);

}  // namespace gloam::effect
