// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_GTAO_GLSL
#define GLOAM_METHODS_GTAO_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/occlusion/gtao.glsl"

// Ground-truth ambient occlusion (Jimenez et al. 2016): two horizons in each slice through the eye and the closed
// integral between them, weighted by the cosine. A sample loses weight with its distance by the linear falloff, which
// moves its horizon towards the tangent plane. The result is divided by the integral over the slices' own half
// planes, so a bare plane is exactly open, at any tilt and with any number of slices.
struct GloamGtao {
    uint steps;  // taps along each half of a slice, at least 1
};

// occlusion by horizon slices (METHOD-gtao): `weighted mean over slices` [Jimenez et al. 2016].
// Error: 6e-6, 6e-5 where a slice nearly lies in the tangent plane, but for taps within rounding of a pixel's border.
GloamEstimate gloam_gtao(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamGtao settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    vec3 view = gloam_toward_eye(position, camera.orthographic);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    float turns = gloam_turns(kernel.angle);
    uint steps = max(settings.steps, 1u);
    uint slices = gloam_whole_samples(kernel.count, 2u * steps) / (2u * steps);
    float occluded = 0.0;
    float whole = 0.0;
    for (uint i = 0u; i < slices; ++i) {
        GloamSliceSample random = gloam_slice_sample(kernel.first / (2u * steps) + i + 1u, turns);
        GloamSlice slice = gloam_slice(random.direction * gloam_upright(camera), view, n);
        GloamSliceAxes axes = gloam_slice_axes(slice, n);
        for (int side = 0; side < 2; ++side) {
            float towards = side == 0 ? 1.0 : -1.0;
            float lowest = -towards * slice.normal.y;  // cosine of the tangent plane's angle from the view vector
            float horizon = lowest;
            for (uint k = 0u; k < steps; ++k) {
                float share = (float(k) + random.jitter) / float(steps);
                ivec2 at = gloam_footprint_pixel(footprint, towards * share * share * random.direction);
                float depth = gloam_fetch_depth(at);
                vec3 seen = gloam_footprint_position(footprint, at, depth) - position;
                vec2 offset = vec2(dot(seen, axes.view), dot(seen, axes.tangent));
                float raised = gloam_gtao_horizon(horizon, lowest, offset, kernel.radius);
                bool counts = depth > 0.0 && at != footprint.pixel && dot(seen, n) > kernel.bias &&
                              !gloam_tap_rejected(-position.z, depth, kernel.farthest);
                horizon = counts ? raised : horizon;
            }
            if (horizon > lowest) {
                occluded += slice.weight * gloam_gtao_side(horizon, towards * slice.angle,
                                                           vec2(slice.normal.x, towards * slice.normal.y));
            }
        }
        whole += slice.weight * gloam_slice_whole(slice);
    }
    return gloam_slice_estimate(occluded, whole, slices, steps);
}

#endif
