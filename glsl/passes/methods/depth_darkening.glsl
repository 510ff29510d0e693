// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_DEPTH_DARKENING_GLSL
#define GLOAM_METHODS_DEPTH_DARKENING_GLSL

#include "gloam/filter/gaussian.glsl"
#include "gloam/occlusion/pair_gather.glsl"

#define GLOAM_METHOD_SAMPLES(count, method) gloam_paired_samples(count)

// Depth darkening (Luft, Colditz and Deussen 2006; CS-R) by samples: the unsharp mask of the depth, lambda max(D - G * D, 0), G a Gaussian
// whose deviation is half the radius, cut off at the radius. It darkens what lies behind its surroundings; it is no occlusion. Depths are
// those of opposite pairs, along the view vector: a plane is not darkened at any tilt, up to the border of the image.
// Reads intensity (lambda, per radius of depth) and range: no surface counts as further than that before or behind the point.

vec2 gloam_method_pair_occlusion(GloamPair pair, GloamKernel kernel, GloamMethod method) {
    float weight = gloam_gaussian(dot(pair.point, pair.point), 0.5);
    vec2 heights = clamp(pair.heights, -method.range, method.range);
    float nearer = 0.5 * (heights.x + heights.y) - kernel.bias;
    return weight * vec2(method.intensity * nearer / kernel.radius, 1.0);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_pair_gather(position, normal, camera, kernel, method);
}

#endif
