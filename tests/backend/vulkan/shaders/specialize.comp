// SPDX-License-Identifier: MIT
#version 450
// Reports its specialization constants and the number of work groups.
layout(local_size_x_id = 7) in;
layout(constant_id = 0) const float a_float = 1.5;
layout(constant_id = 3) const uint a_uint = 2u;
layout(constant_id = 4) const int an_int = 3;
layout(constant_id = 5) const bool a_bool = false;
layout(std430, binding = 0) buffer Values { uint values[]; };

void main() {
    if (gl_GlobalInvocationID.x == 0u) {
        values[0] = floatBitsToUint(a_float);
        values[1] = a_uint;
        values[2] = uint(an_int);
        values[3] = a_bool ? 1u : 0u;
        values[4] = gl_WorkGroupSize.x;
    }
    atomicAdd(values[5], 1u);
}
