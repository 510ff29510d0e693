// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_SWEEP_GLSL
#define GLOAM_METHODS_SWEEP_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/occlusion/sweep.glsl"

// The horizon sweep: slices through the eye in which each direction counts with the falloff at the distance of the
// first surface along it, weighted by the cosine (gloam/occlusion/sweep.glsl). The result is divided by the integral
// over the slices' own half planes, so a bare plane is exactly open, at any tilt and with any number of slices.
struct GloamSweep {
    uint steps;               // taps along each half of a slice, at least 1
    float feature_thickness;  // of what stands in front of the rest, in its own widths, >= 0; 1e18: solid; NaN: 0
    uint falloff;             // GLOAM_FALLOFF_*, of a blocker's distance
};

// occlusion by slices, each direction with the falloff at its distance (METHOD-sweep): `sum of w D(rho) (I(H) - I(h))
// over the sum of w (cos n + n sin n)` [gloam, after Jimenez et al. 2016].
// A tap that sees background, the pixel itself, or a rejected surface is skipped. A tap that is not above the tangent
// plane by the bias adds nothing. Error: 2.5e-6, 3e-4 where a surface is seen nearly edge-on, but for taps within
// rounding of a pixel's border, of another's horizon or of a falloff's end.
GloamEstimate gloam_sweep(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamSweep settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    vec3 view = gloam_toward_eye(position, camera.orthographic);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    float turns = gloam_turns(kernel.angle);
    vec2 reach = footprint.reach * footprint.size;
    uint steps = max(settings.steps, 1u);
    uint slices = gloam_whole_samples(kernel.count, 2u * steps) / (2u * steps);
    GloamFootprintProduct above = gloam_footprint_product(footprint, position, n);
    float scale = 1.0 / kernel.radius;
    float thickness = settings.feature_thickness > 0.0 ? min(settings.feature_thickness, GLOAM_FARTHEST) : 0.0;
    GLOAM_PRECISE float occluded = 0.0;  // so that an unrolled loop has the same bits
    float whole = 0.0;
    for (uint i = 0u; i < slices; ++i) {
        GloamSliceSample random = gloam_slice_sample(kernel.first / (2u * steps) + i + 1u, turns);
        GloamSlice slice = gloam_slice(random.direction * gloam_upright(camera), view, n);
        GloamSliceAxes axes = gloam_slice_axes(slice, n);
        GloamFootprintProduct toward = gloam_footprint_product(footprint, position, scale * axes.view);
        GloamFootprintProduct along = gloam_footprint_product(footprint, position, scale * axes.tangent);
        for (int part = 0; part < 2; ++part) {
            float towards = part == 0 ? 1.0 : -1.0;
            GloamSlice half_plane = gloam_sweep_slice(slice, towards);
            GloamSweepSide side = gloam_sweep_side(-half_plane.normal.y);
            for (uint k = 0u; k < steps; ++k) {
                float place = gloam_slice_place((float(k) + random.jitter) / float(steps), max(reach.x, reach.y));
                ivec2 at = gloam_footprint_pixel(footprint, towards * place * random.direction);
                float depth = gloam_fetch_depth(at);
                vec3 tap = gloam_footprint_tap(footprint, at, depth, -position.z);
                vec2 offset = vec2(gloam_footprint_value(toward, tap), gloam_footprint_value(along, tap));
                bool contributes = gloam_tap_sees(depth) && at != footprint.pixel &&
                             !gloam_tap_rejected(-position.z, depth, kernel.farthest);
                bool rises = gloam_footprint_value(above, tap) > kernel.bias;
                side = gloam_sweep_tap(side, half_plane, offset, contributes, rises, settings.falloff, thickness);
            }
            occluded += slice.weight * (side.occluded + side.feature);
        }
        whole += slice.weight * gloam_slice_whole(slice);
    }
    return gloam_slice_estimate(occluded, whole, slices, steps);
}

#endif
