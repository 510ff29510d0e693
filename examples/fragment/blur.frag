// SPDX-License-Identifier: MIT
// The blur behind occlusion.frag, in two draws over the whole image: along x, then along y.

uniform highp sampler2D engine_depth;      // eye-linear, world units, R32F
uniform highp sampler2D engine_occlusion;  // what the draw before has written
uniform bool along_y;                      // in the second draw
uniform float radius;                      // of influence, world units

layout(location = 0) out vec4 blurred;

float gloam_fetch_depth(ivec2 pixel) {
    return texelFetch(engine_depth, pixel, 0).x;
}

float gloam_fetch_occlusion(ivec2 pixel) {
    return texelFetch(engine_occlusion, pixel, 0).x;
}

#include "gloam/filter/bilateral.glsl"

const float SIGMA = 1.0;  // pixels

void main() {
    ivec2 half_width = along_y ? ivec2(0, 2) : ivec2(2, 0);  // pixels
    float sigma_depth = 0.1 * radius;                        // world units
    ivec2 size = textureSize(engine_depth, 0);
    blurred = vec4(gloam_bilateral_filter(ivec2(gl_FragCoord.xy), half_width, size, SIGMA, sigma_depth));
}
