// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "scene/gbuffer.hpp"

namespace gloam::effect {

// The reference of an image: the true occlusion of each pixel, NaN where it is unknown.
using Truth = std::vector<float>;

// Errors of an image over the pixels whose truth is known; all 0 when there are none.
struct Errors {
    std::size_t compared = 0;
    double rmse = 0.0;
    double mean = 0.0;           // of the magnitude
    double percentile_99 = 0.0;  // of the magnitude
    double max = 0.0;            // of the magnitude
    double bias = 0.0;           // mean of image - truth
};

// Errors of an occlusion image. Throws std::invalid_argument when the sizes disagree.
[[nodiscard]] Errors errors_of(std::span<const float> occlusion, std::span<const float> truth);

// True occlusion at a world-space point, for a radius in world units.
using TrueOcclusion = std::function<double(const glm::dvec3& world, double radius)>;

// The truth of each pixel of a view. NaN at the background, and where the ball of the radius around the point
// comes within a pixel of the image's border, because the image does not show what is outside.
[[nodiscard]] Truth truth_of(const scene::GBuffer& view, double radius, const TrueOcclusion& true_occlusion);

// A reference image as truth: NaN at the background. Throws std::invalid_argument when the sizes disagree.
[[nodiscard]] Truth truth_from(const scene::GBuffer& view, std::span<const float> reference);

}  // namespace gloam::effect
