// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_GATHER_KERNEL_GLSL
#define GLOAM_OCCLUSION_GATHER_KERNEL_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/geometry/finite.glsl"

// The samples that one pixel takes in one frame: points first + 1 ... first + count of a Halton sequence (TSSAO-4).
struct GloamKernel {
    float radius;  // of influence, world units
    float bias;    // world units: hides the rounding of positions and depths, so no less than a depth's spacing (2^-23 of it in
                   // float32, 2^-10 in halves: 0.05 at 50 units); the presets have 1e-3 of the radius, whatever the depth,
                   // and a share of the depth can be asked for besides (bias_depth)
    float angle;   // rotation of the kernel, radians; 0 once the pixel has converged (TSSAO-ROT)
    uint first;    // j, samples taken before
    uint count;    // k
};

// Whether there is anything to gather at a point: a surface in front of the eye with a normal, and a radius of influence.
// position: view space, world units. normal: view space, any length. radius: world units.
// Returns false for background depth, for a zero or non-finite normal, and for a radius that is not positive and finite.
// Error: none.
bool gloam_can_gather(vec3 position, vec3 normal, float radius) {
    bool point = gloam_is_finite3(position) && !gloam_is_background(-position.z);
    bool facing = gloam_is_finite3(normal) && max(max(abs(normal.x), abs(normal.y)), abs(normal.z)) >= 1.175494351e-38;
    return point && facing && radius >= 1.175494351e-38 && radius <= 3.402823466e38;
}

#endif
