// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_GTAO_GLSL
#define GLOAM_METHODS_GTAO_GLSL

#include "gloam/geometry/length.glsl"
#include "gloam/occlusion/falloff.glsl"
#include "gloam/occlusion/gtao.glsl"
#include "gloam/occlusion/slice_gather.glsl"

#define GLOAM_METHOD_SAMPLES(count, method) gloam_slice_samples(count, method.steps)

// Horizon slices weighted by the cosine and divided by their own weights (GTAO, Jimenez et al. 2016). A sample loses weight with its distance
// as the linear falloff has it. Reads steps.

vec3 gloam_method_slice_view(vec3 eye) {
    return eye;
}

GloamMarch gloam_method_slice_start(GloamSlice slice, vec3 normal, float share, GloamMethod method) {
    vec2 lowest = gloam_gtao_lowest(slice);
    return GloamMarch(vec2(-1.0, lowest.y), vec2(-1.0, lowest.x), share, 0u);
}

GloamMarch gloam_method_slice_step(GloamMarch march, GloamSlice slice, vec3 offset, bool positive, GloamKernel kernel,
                                   GloamMethod method) {
    float weight = gloam_falloff_linear(gloam_length(offset), kernel.radius);
    if (positive) {
        march.positive.x = gloam_gtao_horizon(march.positive.x, march.positive.y, offset, slice.view, weight);
    } else {
        march.negative.x = gloam_gtao_horizon(march.negative.x, march.negative.y, offset, slice.view, weight);
    }
    return march;
}

float gloam_method_slice_ball(GloamMarch march, bool positive) {
    return 1.0;
}

// The falloff draws every horizon away from the view vector: none is so high that no other can be higher.
bool gloam_method_slice_full(GloamMarch march) {
    return false;
}

vec2 gloam_method_slice_end(vec2 accumulated, GloamMarch march, GloamSlice slice, GloamMethod method) {
    return gloam_gtao_add(accumulated, slice, vec2(march.negative.x, march.positive.x));
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_slice_gather(position, normal, camera, kernel, method);
}

#endif
