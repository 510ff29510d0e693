// SPDX-License-Identifier: MIT
#version 450
// values[i] = first + i * step.
layout(local_size_x = 64) in;
layout(std430, binding = 0) writeonly buffer Values { float values[]; };
layout(push_constant) uniform Constants { float first; float step; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < uint(values.length())) values[i] = first + float(i) * step;
}
