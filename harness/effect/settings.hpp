// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace gloam::effect {

// How the occlusion of a pixel is estimated.
enum class Method {
    hemisphere,  // TSSAO-3: points in the half ball above the surface, linear falloff
    disc,        // TSSAO-12: surface points under a disc around the pixel: how concave the surface is
};

// The smallest projected radius worth sampling: below it all samples fall on the pixel itself.
constexpr float one_pixel = 1.0F;

// Everything that decides what a frame looks like.
struct Settings {
    Method method = Method::hemisphere;
    float radius = 0.5F;  // of influence, world units, > 0
    float bias = 0.005F;  // world units, >= 0: differences below it are rounding, not occlusion
    float range =
        1.0F;  // hemisphere: blockers further in front than this are other objects; world units, > 0
    float epsilon = 0.025F;             // disc: distance at which a patch counts fully, world units, > 0
    std::uint32_t samples = 32;         // k, for each pixel in each frame, >= 1
    std::uint32_t table_size = 65'536;  // samples after which the sequence starts over, 1 to 2^24
    float weight_max = 500.0F;          // samples in the mean at most, 1 to 2^23
    float c_rot = 0.5F;  // kernels are rotated by pixel below this convergence; 0: never, above 1: always
    float c_adaptive = 0.2F;  // the filter leaves pixels of this convergence as they are
    bool filter = true;
    int filter_half_width = 2;  // pixels on each side: 2 is 5 x 5
    float least_radius =
        one_pixel;  // pixels: below this projected radius the occlusion is 0 without a sample; 0: never
    bool skip_background = true;  // off: background goes the long way, to the same result
};

// The same settings for another radius: bias, range and epsilon keep their proportion to it.
[[nodiscard]] Settings with_radius(Settings settings, float radius);

// Throws std::invalid_argument that names the first setting outside its range.
void validate(const Settings& settings);

}  // namespace gloam::effect
