// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/gbuffer.hpp"

namespace gloam::stress {

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
