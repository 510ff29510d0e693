// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_BITMASK_GLSL
#define GLOAM_METHODS_BITMASK_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/occlusion/gtao.glsl"

// Visibility bitmask (Therrien et al. 2023). A sample covers the sectors of a slice between its front and its back,
// so light passes behind thin things. Sectors are equal parts of the cosine-weighted half plane. Each slice takes
// only samples up to a random distance, uniform up to the radius. In the mean that is the linear falloff.
struct GloamBitmask {
    float thickness;  // world units: how far behind its front a surface blocks
    uint steps;       // taps along each half of a slice, at least 1
};

// Sectors between the front and the back of a sample, of equal shares of the cosine-weighted half plane
// (gloam_slice_fraction_cosine, gloam_bitmask_sectors).
// front, back: in the slice, (along view, along tangent), any length. Returns bits, as gloam_bitmask_sectors; none
// where front and back are alike.
// Error: none, but for ends within rounding of a sector's centre.
uint gloam_bitmask_between(vec2 front, vec2 back, GloamSlice slice) {
    float first = gloam_slice_fraction_cosine(front * inversesqrt(max(dot(front, front), GLOAM_LEAST_SQUARE)), slice);
    float second = gloam_slice_fraction_cosine(back * inversesqrt(max(dot(back, back), GLOAM_LEAST_SQUARE)), slice);
    return gloam_bitmask_sectors(vec2(min(first, second), max(first, second)));
}

// covered sectors of slices (METHOD-bitmask): `weighted mean of sectors / 32 between fronts and backs` [Therrien et al.
// 2023].
// Error: 2.5e-6, but for samples within rounding of a sector's border or a pixel's.
GloamEstimate gloam_bitmask(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamBitmask settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    vec3 view = gloam_toward_eye(position, camera.orthographic);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    float turns = gloam_turns(kernel.angle);
    uint steps = max(settings.steps, 1u);
    uint slices = gloam_whole_samples(kernel.count, 2u * steps) / (2u * steps);
    float thickness = settings.thickness > 0.0 && settings.thickness <= GLOAM_FARTHEST ? settings.thickness : 0.0;
    float occluded = 0.0;
    float whole = 0.0;
    for (uint i = 0u; i < slices; ++i) {
        GloamSliceSample random = gloam_slice_sample(kernel.first / (2u * steps) + i + 1u, turns);
        vec2 direction = random.direction * gloam_upright(camera);
        GloamSlice slice = gloam_slice(direction, view, n);
        GloamSliceAxes axes = gloam_slice_axes(slice, n);
        float nearest = random.share * kernel.radius;  // only samples that are nearer count
        uint sectors = 0u;
        for (int side = 0; side < 2; ++side) {
            float towards = side == 0 ? 1.0 : -1.0;
            for (uint k = 0u; k < steps; ++k) {
                float share = (float(k) + random.jitter) / float(steps);
                ivec2 at = gloam_footprint_pixel(footprint, towards * share * share * random.direction);
                float depth = gloam_fetch_depth(at);
                vec3 seen = gloam_footprint_position(footprint, at, depth) - position;
                vec2 offset = vec2(dot(seen, axes.view), dot(seen, axes.tangent));
                vec2 back = vec2(offset.x - thickness, offset.y);
                bool counts = depth > 0.0 && dot(offset, offset) < nearest * nearest && at != footprint.pixel &&
                              dot(seen, n) > kernel.bias && !gloam_tap_rejected(-position.z, depth, kernel.farthest);
                if (counts) sectors |= gloam_bitmask_between(offset, back, slice);
            }
        }
        occluded += slice.weight * gloam_slice_whole(slice) * gloam_bitmask_occlusion(sectors);
        whole += slice.weight * gloam_slice_whole(slice);
    }
    return gloam_slice_estimate(occluded, whole, slices, steps);
}

#endif
