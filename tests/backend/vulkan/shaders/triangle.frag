// SPDX-License-Identifier: MIT
#version 450
// Adds a value to the fragment's texel.
layout(binding = 0, r32f) uniform image2D values;
layout(push_constant) uniform Constants { float value; };

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    imageStore(values, pixel, imageLoad(values, pixel) + value);
}
