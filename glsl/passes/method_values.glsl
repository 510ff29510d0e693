// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_METHOD_VALUES_GLSL
#define GLOAM_PASSES_METHOD_VALUES_GLSL

// Values of the settings that methods have, as a buffer holds them: a method's own struct is made of some of them
// (METHOD).
struct MethodValues {
    float range;         // world units
    float epsilon;       // world units
    float intensity;
    float thickness;     // world units
    float angle_bias;    // radians
    float mip_distance;  // pixels
    uint steps;
    float disagreement;  // in occlusion
};

#endif
