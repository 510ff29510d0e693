// SPDX-License-Identifier: MIT
// passes/study/spatial_filter.comp as a fragment shader, by convergence: one pixel, along one axis. Draw along x, then along
// y.
#define UNROLL
#define HOLDS_ROW false

const int PIXELS = 1;
layout(constant_id = 1) const int HALF_WIDTH = 2;         // taps on each side
layout(constant_id = 2) const bool along_y = false;       // the second of the two passes
layout(constant_id = 0) const bool orthographic = false;  // the camera; else perspective

// Those of passes/study/spatial_filter.comp, with the same meaning.
struct Parameters {
    vec2 p00_p11;
    ivec2 size;
    float sigma_pixels;
    float c_adaptive;
    float weight_max;
    float cap;
};
uniform Parameters parameters;
uniform sampler2D history_image;  // (occlusion, samples accumulated, samples of the sequence used, depth)
uniform sampler2D along_x_image;  // what this pass has written along x; read where along_y is set

layout(location = 0) out vec4 filtered;  // the occlusion in x

struct Source {
    float occlusion;
    float samples;
    float depth;
};

Source source_at(ivec2 pixel) {
    vec4 texel = texelFetch(history_image, pixel, 0);
    if (along_y) texel.x = texelFetch(along_x_image, pixel, 0).x;
    return Source(texel.x, texel.y, texel.w);
}

ivec2 filter_axis() {
    return ivec2(along_y ? 0 : 1, along_y ? 1 : 0);
}

#include "passes/study/filters/convergence.glsl"

void main() {
    read_row(ivec2(gl_FragCoord.xy));
    filtered = vec4(filtered_occlusion(REACH));
}
