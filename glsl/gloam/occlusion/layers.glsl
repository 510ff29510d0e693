// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_LAYERS_GLSL
#define GLOAM_OCCLUSION_LAYERS_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/sampling/unit_interval.glsl"

// What more than one depth image says of a point: layers peeled one behind the other (Bavoil and Sainz 2009), or views of other cameras.

// Occlusion over layers or views: the largest, since each can only miss what the others see. A layer given twice changes nothing.
// occlusion: largest so far, starting at 0. layer: of one more. Both in [0, 1]; outside, the nearer end; 0 for NaN.
// Returns occlusion in [0, 1]. Error: none.
float gloam_layers_occlusion(float occlusion, float layer) {
    return max(gloam_unit_interval(occlusion), gloam_unit_interval(layer));
}

// Whether a sample point lies inside one object, between its front and its back: no guess of a thickness is needed.
// sample_depth: of the point, eye-linear, world units. front, back: depths of the two sides at its pixel, world units. Background at the
// back: solid all the way.
// Returns 1 if front <= sample_depth <= back, else 0; 0 for background in front and for a sample at or behind the eye.
// Error: none.
float gloam_layer_blocked(float sample_depth, float front, float back) {
    if (gloam_is_background(sample_depth) || gloam_is_background(front)) return 0.0;
    bool before_back = gloam_is_background(back) || sample_depth <= back;
    return front <= sample_depth && before_back ? 1.0 : 0.0;
}

#endif
