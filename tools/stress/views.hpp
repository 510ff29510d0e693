// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/gbuffer.hpp"

namespace gloam::stress {

// A wall across the whole view at depth 3, parallel to the image: every sample of it is open.
[[nodiscard]] scene::GBuffer plane(gpu::Extent extent);

// The same wall with every other field of 6 x 5 pixels a quarter unit nearer: occlusion along every edge.
[[nodiscard]] scene::GBuffer steps(gpu::Extent extent);

// NaN, infinities, negative, zero, subnormal, tiny and huge.
[[nodiscard]] const std::vector<float>& bad_values();

// How many values are outside [0, 1] or NaN.
[[nodiscard]] std::size_t outside_unit(const std::vector<float>& values);

// Which pixels of an image something reaches, row by row.
using Mask = std::vector<bool>;

// The pixels whose occlusion may depend on the depth at `source`: those whose ball of influence, of radius
// `radius` around their surface point and as the eye sees it, projects onto it or onto one of its neighbours
// (a sample takes the nearest pixel; normals from depth take the four neighbours), and `source` itself.
[[nodiscard]] Mask depth_footprint(const scene::GBuffer& view, double radius, glm::ivec2 source);

// One pixel.
[[nodiscard]] Mask single_pixel(gpu::Extent extent, glm::ivec2 source);

// The mask and all pixels up to `pixels` away along each axis: what a filter makes of it.
[[nodiscard]] Mask widened(const Mask& mask, gpu::Extent extent, int pixels);

// Largest distance along an axis of a pixel in the mask from `source`, in pixels; 0 for an empty mask.
[[nodiscard]] int reach_of(const Mask& mask, gpu::Extent extent, glm::ivec2 source);

}  // namespace gloam::stress
