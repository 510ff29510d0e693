// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_PAIR_GATHER_GLSL
#define GLOAM_OCCLUSION_PAIR_GATHER_GLSL

#include "gloam/geometry/camera.glsl"
#include "gloam/geometry/height_at.glsl"
#include "gloam/geometry/safe_normalize.glsl"
#include "gloam/numeric/sincos.glsl"
#include "gloam/occlusion/estimator.glsl"
#include "gloam/occlusion/further_layers.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/method_parameters.glsl"
#include "gloam/sampling/halton_disc.glsl"

// Methods that look at two opposite surface points at a time (CS-I, CS-P): where one of them tells nothing, the other stands for
// both. The loop over the pairs; a method says what a pair contributes.

// Defined by the user: eye-linear depth of a pixel inside the image, in world units.
float gloam_fetch_depth(ivec2 pixel);

// Two opposite taps as a method sees them. The surface seen at a tap is moved along the tangent plane to the place that was aimed at, on the
// line along the view vector: opposite taps of a bare plane are then opposite at any tilt, and at the border of the image.
struct GloamPair {
    vec2 point;     // of the first tap in the unit disc, y as in view space; the second is opposite
    vec2 heights;   // of the surface at both taps over the disc parallel to the image, towards the eye, world units
    vec3 first;     // from the shaded point to the surface seen there, view space, world units
    vec3 second;    // likewise of the opposite tap
    vec3 view;      // from the shaded point to the eye, unit
    vec3 normal;    // of the shaded point, unit
};

// Defined by the method: what a pair contributes.
// Returns (occlusion times weight, weight).
vec2 gloam_method_pair_occlusion(GloamPair pair, GloamKernel kernel, GloamMethod method);

// Background counts as a surface this many radii behind the shaded point.
const float GLOAM_PAIR_FAR = 1e4;

// From the shaded point to the surface seen at a pixel.
// position: of the shaded point, view space, world units. at: inside the image. radius: world units.
// Returns the offset in world units; the zero vector where it is not finite. Error: 4e-6, growing as the point comes nearer than a thousandth of the depth.
vec3 gloam_pair_offset(vec3 position, ivec2 at, GloamCamera camera, float radius) {
    float depth = gloam_fetch_depth(at);
    float farthest = -position.z + GLOAM_PAIR_FAR * radius;
    vec3 offset = gloam_camera_position(at, gloam_is_background(depth) ? farthest : depth, camera) - position;
    return gloam_is_finite3(offset) ? offset : vec3(0.0);
}

// Samples that are taken where `count` are asked for: those of whole pairs. What follows in the sequence begins that many samples later.
// count: k, below 2^32 - 1.
// Returns the even number that is not below. Error: none.
uint gloam_paired_samples(uint count) {
    return count + (count & 1u);
}

// All samples of one pixel in one frame; an odd number is taken as the even one above it. Of further layers each tap takes, one after the other,
// the one with which the pair blocks most.
// position: of the surface, view space, world units. normal: view space, any length.
// Returns (sum, samples taken), see gloam_paired_samples, for gloam_estimator_mean; 0 where no pair tells anything; outside the image the nearest pixel counts.
// (0, 0) where there is nothing to gather: background, no normal, no radius. Error: that of the contributions, but for taps within
// rounding of a pixel's border.
vec2 gloam_pair_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    if (!gloam_can_gather(position, normal, kernel.radius)) return vec2(0.0);
    vec3 n = gloam_safe_normalize(normal, vec3(0.0));
    vec2 center = gloam_camera_uv(position, camera);
    vec2 reach = gloam_camera_radius(kernel.radius, -position.z, camera);
    vec3 ahead = vec3(0.0, 0.0, 1.0);
    vec3 view = camera.orthographic ? ahead : gloam_safe_normalize(-position, ahead);
    vec2 upright = vec2(1.0, camera.p00_p11.y < 0.0 ? -1.0 : 1.0);
    vec2 weighted = vec2(0.0);
    vec2 turn = gloam_sincos(kernel.angle);
    for (uint i = 0u; i < kernel.count; i += 2u) {
        vec2 point = gloam_halton_disc((kernel.first + i) / 2u + 1u, turn);
        ivec2 first = gloam_nearest_pixel(center + reach * point, camera.size);
        ivec2 second = gloam_nearest_pixel(center - reach * point, camera.size);
        vec3 aim = vec3(kernel.radius * point * upright, 0.0);
        vec3 one = gloam_pair_offset(position, first, camera, kernel.radius);
        vec3 other = gloam_pair_offset(position, second, camera, kernel.radius);
        vec2 most = vec2(0.0);
        for (int look = 0; look < 2 * GLOAM_LAYERS - 1; ++look) {
            vec3 a = one;
            vec3 b = other;
            if (look > 0) {
                bool of_first = look < GLOAM_LAYERS;
                ivec2 at = of_first ? first : second;
                float depth = abs(GLOAM_FURTHER_LAYER(at, of_first ? look : look - GLOAM_LAYERS + 1));
                if (gloam_is_background(depth)) continue;
                vec3 seen = gloam_camera_position(at, depth, camera) - position;
                a = of_first ? seen : a;
                b = of_first ? b : seen;
            }
            vec2 heights = vec2(gloam_height_at(a, aim, view, n), gloam_height_at(b, -aim, view, n));
            GloamPair pair = GloamPair(point * upright, heights, aim + heights.x * view, heights.y * view - aim, view, n);
            vec2 found = gloam_method_pair_occlusion(pair, kernel, method);
            // As much is taken too: beside a tap that tells nothing its partner cannot tell more either, until both are replaced.
            bool as_much = most.y > 0.0 ? found.x * most.y >= most.x * found.y : found.y > 0.0;
            if (look > 0 && !as_much) continue;
            most = found;
            one = a;
            other = b;
        }
        weighted += most;
    }
    return gloam_estimator_of_weighted(weighted, gloam_paired_samples(kernel.count));
}

#endif
