// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_DEPTH_DARKENING_GLSL
#define GLOAM_METHODS_DEPTH_DARKENING_GLSL

#include "gloam/filter/weights.glsl"
#include "gloam/gather/method.glsl"
#include "gloam/gather/pair.glsl"

// Depth darkening (Luft, Colditz and Deussen 2006; CS-R) by samples: the unsharp mask of the depth, lambda max(D - G
// * D, 0). G is a Gaussian whose deviation is half the radius, cut off at the radius. It darkens surfaces behind
// their surroundings and is not an occlusion. Depths are those of opposite pairs, along the view vector, so a plane
// is not darkened at any tilt, up to the border of the image.

struct GloamDepthDarkening {
    float range;      // world units: no surface counts as further than that before or behind the point
    float intensity;  // lambda, per radius of depth
};

// unsharp mask of the depth (METHOD-depth_darkening): `lambda max(D - G * D, 0) / R` [Luft, Colditz and Deussen 2006,
// CS-R].
// All samples of one pixel in one frame, in pairs.
GloamEstimate gloam_depth_darkening(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel,
                                    GloamDepthDarkening settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamLinePoint point = gloam_line_point(position, n, kernel.radius, camera);
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    float occluded = 0.0;
    float whole = 0.0;
    for (uint i = 0u; i < kernel.count; i += 2u) {
        vec2 tap = gloam_turn_disc(gloam_disc_point((kernel.first + i) / 2u + 1u).xy, turn);
        vec3 aim = vec3(kernel.radius * tap * point.upright, 0.0);
        float first = gloam_pair_height(point, tap, aim, kernel.radius);
        float second = gloam_pair_height(point, -tap, -aim, kernel.radius);
        float weight = gloam_gaussian(dot(tap, tap), 0.5);
        float nearer =
            0.5 * (clamp(first, -settings.range, settings.range) + clamp(second, -settings.range, settings.range)) -
            kernel.bias;
        occluded += weight * settings.intensity * nearer / kernel.radius;
        whole += weight;
    }
    return gloam_estimate(occluded, whole, gloam_paired_samples(kernel.count));
}

#endif
