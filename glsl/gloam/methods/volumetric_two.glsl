// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_VOLUMETRIC_TWO_GLSL
#define GLOAM_METHODS_VOLUMETRIC_TWO_GLSL

#include "gloam/methods/volumetric.glsl"

// volumetric at two radii (Loos and Sloan 2010). Half of the samples are in a ball of a quarter of the radius, for
// fine detail, and half in the whole ball. The amounts by which both exceed a plane's 1/2 are added. (The larger of
// the two would depend on the noise of a frame's few samples.)

// The fine radius, as a fraction of the other.
const float GLOAM_FINE_BALL = 0.25;

// A pair at both radii.
const uint GLOAM_TWO_BALLS_UNIT = 4u;

// All samples of one pixel in one frame, as many at both radii: whole fours, at least one. Parameters and result are
// those of gloam_volumetric.
GloamEstimate gloam_volumetric_two(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel) {
    GloamKernel broad = kernel;
    broad.first = kernel.first / 2u;
    broad.count = gloam_whole_samples(kernel.count, GLOAM_TWO_BALLS_UNIT) / 2u;
    GloamKernel fine = broad;
    fine.radius = GLOAM_FINE_BALL * kernel.radius;
    GloamEstimate far = gloam_volumetric(position, normal, camera, broad);
    GloamEstimate near = gloam_volumetric(position, normal, camera, fine);
    if (!(far.samples > 0.0)) return GLOAM_NO_ESTIMATE;
    return GloamEstimate(gloam_two_balls(near.occlusion, far.occlusion), float(2u * broad.count), 0u);
}

#endif
