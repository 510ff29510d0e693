// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_METHOD_PARAMETERS_GLSL
#define GLOAM_OCCLUSION_METHOD_PARAMETERS_GLSL

// What a method may need besides its kernel. Each method says which of these it reads, and how.
struct GloamMethod {
    float range;       // world units: blockers further in front than this are other objects
    float epsilon;     // world units: distance below which a patch counts no more
    float intensity;   // factor of the result
    float thickness;   // world units: how far behind its front a surface blocks
    float angle_bias;    // radians above the tangent plane below which nothing blocks
    float mip_distance;  // pixels from which taps read level 1 of the depth chain, twice as far level 2, and so on; 0: none does
    uint steps;          // taps along each half of a slice, or resolutions, each half of the one before; at least 1
    float disagreement;  // of neighbours at half the resolution, in occlusion, beyond which a pixel is sampled in full
};

#endif
