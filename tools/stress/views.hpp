// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gbuffer.hpp"

namespace gloam::stress {

// A wall across the whole view at depth 3, parallel to the image: every sample of it is open.
[[nodiscard]] scene::GBuffer plane(gpu::Extent extent);

// The same wall with every other field of 6 x 5 pixels a quarter unit nearer: occlusion along every edge.
[[nodiscard]] scene::GBuffer steps(gpu::Extent extent);

// A bad value and what it is called.
struct BadValue {
    const char* name;
    float value;
};

// NaN, infinities, negative, zero, subnormal, tiny and huge.
[[nodiscard]] const std::vector<BadValue>& bad_values();

// How many values are outside [0, 1] or NaN.
[[nodiscard]] std::size_t outside_unit(const std::vector<float>& values);

}  // namespace gloam::stress
