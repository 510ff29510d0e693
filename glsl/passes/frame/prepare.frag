// SPDX-License-Identifier: MIT
#version 450
// prepare.comp as a fragment shader: one draw for each level.
uniform highp sampler2D stored_image;
layout(location = 0) out highp float depth;

#include "gloam/sampling/depth_levels.glsl"
#include "passes/frame/parameters.glsl"

struct LevelParameters {
    vec2 numerator;  // of depth in radii (gloam/sampling/depth_levels.glsl)
    vec2 divisor;
    float far;
    int level;  // that is drawn
};
FRAME_PARAMETERS(LevelParameters)

void main() {
    ivec2 pixel = (ivec2(gl_FragCoord.xy) << parameters.level) + (1 << parameters.level >> 1);
    float stored = texelFetch(stored_image, min(pixel, textureSize(stored_image, 0) - 1), 0).x;
    depth = gloam_level_depth(stored, parameters.numerator, parameters.divisor, parameters.far);
}
