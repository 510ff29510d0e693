// SPDX-License-Identifier: MIT
#version 450
// Chains of dependent steps (a linear congruential generator) that no compiler can shorten; one a work group.
// At most 65535 steps: lavapipe ends an invocation's loops there without a word.
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Values { uint sum; };
layout(push_constant) uniform Constants { uint steps; };

void main() {
    uint x = gl_WorkGroupID.x + gl_WorkGroupID.y + 1u;
    for (uint i = 0u; i < steps; ++i) x = (x ^ i) * 1664525u + 1013904223u;
    atomicAdd(sum, x);
}
