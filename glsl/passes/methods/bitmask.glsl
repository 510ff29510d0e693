// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_BITMASK_GLSL
#define GLOAM_METHODS_BITMASK_GLSL

#include "gloam/geometry/length.glsl"
#include "gloam/occlusion/slice_gather.glsl"
#include "gloam/occlusion/visibility_bitmask.glsl"

#define GLOAM_METHOD_SAMPLES(count, method) gloam_slice_samples(count, method.steps)

// Visibility bitmask (Therrien et al. 2023): samples cover sectors of a slice between their front and their back, so that light passes
// behind thin things. Sectors are equal shares of the cosine-weighted half plane. Each slice takes only samples up to a random distance,
// uniform up to the radius: in the mean that is the linear falloff.
// Reads thickness and steps.

vec3 gloam_method_slice_view(vec3 eye) {
    return eye;
}

GloamMarch gloam_method_slice_start(GloamSlice slice, vec3 normal, float share, GloamMethod method) {
    return GloamMarch(vec2(0.0), vec2(0.0), share, 0u);
}

GloamMarch gloam_method_slice_step(GloamMarch march, GloamSlice slice, vec3 offset, bool positive, GloamKernel kernel,
                                   GloamMethod method) {
    if (!(gloam_length(offset) < march.share * kernel.radius)) return march;
    float front = gloam_slice_fraction_cosine(gloam_slice_direction(offset, slice), slice);
    float back = gloam_slice_fraction_cosine(gloam_bitmask_back(offset, slice, method.thickness), slice);
    march.sectors |= gloam_bitmask_sectors(vec2(min(front, back), max(front, back)));
    return march;
}

float gloam_method_slice_ball(GloamMarch march, bool positive) {
    return march.share;
}

bool gloam_method_slice_full(GloamMarch march) {
    return march.sectors == 0xFFFFFFFFu;
}

vec2 gloam_method_slice_end(vec2 accumulated, GloamMarch march, GloamSlice slice, GloamMethod method) {
    return accumulated + slice.weight * gloam_slice_whole(slice) * vec2(gloam_bitmask_occlusion(march.sectors), 1.0);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_slice_gather(position, normal, camera, kernel, method);
}

#endif
