// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_METHOD_VALUES_GLSL
#define GLOAM_PASSES_METHOD_VALUES_GLSL

// The settings of all methods in one buffer layout. METHOD builds a method's own struct from some of them.
struct MethodValues {
    float range;         // world units
    float epsilon;       // world units
    float intensity;
    float thickness;     // world units
    float angle_bias;    // radians
    float mip_distance;  // pixels
    uint steps;
    float disagreement;  // in occlusion
    float feature_thickness;  // in widths of the feature
    int layers;
};

#endif
