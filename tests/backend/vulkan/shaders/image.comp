// SPDX-License-Identifier: MIT
#version 450
// to(p) = (from(p), x, y, 1), and the same into a buffer row by row.
layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0, r32f) uniform readonly image2D from;
layout(binding = 1, rgba32f) uniform writeonly image2D to;
layout(std430, binding = 2) writeonly buffer Values { vec4 values[]; };

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(from);
    if (pixel.x >= size.x || pixel.y >= size.y) return;
    vec4 value = vec4(imageLoad(from, pixel).r, vec2(pixel), 1.0);
    imageStore(to, pixel, value);
    values[pixel.y * size.x + pixel.x] = value;
}
