// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_FRAME_PREPARE_GLSL
#define GLOAM_PASSES_FRAME_PREPARE_GLSL

// Depth of the frame, for compute and fragment shaders. They declare before it:
//   vec4 levels_before(vec2 at)   level 0 of the frame before, of the four pixels around a place of the image

#include "gloam/sampling/depth_levels.glsl"
#include "gloam/temporal/frame_history.glsl"
#include "passes/frame/parameters.glsl"

layout(constant_id = 1) const bool orthographic = false;  // both cameras; else perspective
layout(constant_id = 8) const bool history = false;       // there was a frame before

struct PrepareParameters {
    mat4x3 before;   // where a pixel's point was (gloam/temporal/frame_history.glsl)
    vec2 numerator;  // of depth in radii (gloam/sampling/depth_levels.glsl)
    vec2 divisor;
    vec2 inverse_size;
    vec2 usual;      // usual_share()
    float far;
};
FRAME_PARAMETERS(PrepareParameters)

float depth_of(float stored) {
    return gloam_level_depth(stored, parameters.numerator, parameters.divisor, parameters.far);
}

// -1 where the frame before did not show the surface of a pixel, which stands for its block; else 1.
float sign_of(ivec2 pixel, float depth) {
    if (!history) return 1.0;
    vec3 was = gloam_frame_before(vec2(pixel), depth, parameters.before, orthographic);
    float tolerance = 0.01 * usual_share(was.z, parameters.usual, orthographic);
    bool moved = gloam_frame_moved(was.z, abs(levels_before(was.xy)), 0.5 * GLOAM_FARTHEST_LEVEL_DEPTH, tolerance);
    return moved ? -1.0 : 1.0;
}

#endif
