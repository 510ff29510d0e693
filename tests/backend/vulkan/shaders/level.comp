// SPDX-License-Identifier: MIT
#version 450
// The last texel of a level becomes the level's number; of the level before, the texel beyond the edge is read.
layout(local_size_x = 1) in;
layout(binding = 0, r32f) uniform writeonly image2D to;
layout(binding = 1) uniform sampler2D from;
layout(std430, binding = 2) writeonly buffer Values { float values[]; };
layout(push_constant) uniform Parameters { int level; };

void main() {
    imageStore(to, imageSize(to) - 1, vec4(float(level)));
    if (level > 0) values[level - 1] = textureLod(from, vec2(1.5), float(level - 1)).x;
}
