// SPDX-License-Identifier: MIT
#version 450
// Group counts for a dispatch: as many groups in x as there are values above a limit, 1 in y and z.
layout(local_size_x = 1) in;
layout(std430, binding = 0) readonly buffer Values { float values[]; };
layout(std430, binding = 1) writeonly buffer Groups { uint groups[]; };
layout(push_constant) uniform Constants { float limit; };

void main() {
    uint above = 0u;
    for (int i = 0; i < values.length(); ++i) above += values[i] > limit ? 1u : 0u;
    groups[1] = above;
    groups[2] = 1u;
    groups[3] = 1u;
}
