// SPDX-License-Identifier: MIT
#version 450
// Writes and reads far outside its buffer.
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Values { uint values[]; };
layout(push_constant) uniform Constants { uint index; };

void main() {
    values[index] = 0xffffffffu;
    values[1] = values[index + 1u];
    values[0] = 1u;
}
