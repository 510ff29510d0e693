// SPDX-License-Identifier: MIT
#version 450
// One step of a computation whose every result depends on a neighbour's: any missing wait between dispatches shows.
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer From { uint from[]; };
layout(std430, binding = 1) writeonly buffer To { uint to[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    uint n = uint(from.length());
    if (i < n) to[i] = 3u * from[i] + from[(i + n / 2u + 1u) % n];
}
