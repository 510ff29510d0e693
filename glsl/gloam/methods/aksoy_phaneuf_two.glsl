// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_AKSOY_PHANEUF_TWO_GLSL
#define GLOAM_METHODS_AKSOY_PHANEUF_TWO_GLSL

#include "gloam/methods/aksoy_phaneuf.glsl"
#include "gloam/occlusion/aksoy_phaneuf.glsl"
#include "gloam/sampling/whole_samples.glsl"

// aksoy_phaneuf at two radii (Aksoy and Phaneuf 2011; CS-J). Half of the samples are within a quarter of the radius,
// for fine detail, and half within the whole radius. Both results are added and the sum is clamped. (The larger of
// the two would depend on the noise of a frame's few samples.)

// The fine radius, as a fraction of the other.
const float GLOAM_FINE_SHARE = 0.25;

// All samples of one pixel in one frame, as many at both radii. Parameters and result are those of gloam_aksoy_phaneuf.
GloamEstimate gloam_aksoy_phaneuf_two(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel) {
    GloamKernel broad = kernel;
    broad.first = kernel.first / 2u;
    broad.count = gloam_paired_samples(kernel.count) / 2u;
    GloamKernel fine = broad;
    fine.radius = GLOAM_FINE_SHARE * kernel.radius;
    GloamEstimate far = gloam_aksoy_phaneuf(position, normal, camera, broad);
    GloamEstimate near = gloam_aksoy_phaneuf(position, normal, camera, fine);
    if (!(far.samples > 0.0)) return GLOAM_NO_ESTIMATE;
    return GloamEstimate(gloam_two_radii_sum(near.occlusion, far.occlusion), float(2u * broad.count), 0u);
}

#endif
