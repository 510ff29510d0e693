// SPDX-License-Identifier: MIT
#version 450
// Mean and variance of the surfaces in blocks of growing size, for volumetric_area.glsl. Each run computes one level
// from the level before, with one invocation for each of its texels. Writes a texel of each of the three values of
// gloam/gather/pixels.glsl: (mean position, pixels with a surface), variances, covariances.

#include "passes/study/preparation/pass.glsl"
#include "gloam/methods/volumetric_area.glsl"

// A texel of the level before; without a surface outside it.
GloamSurfaceMoments finer(ivec2 texel) {
    int level = parameters.level - 1;
    ivec2 size = gloam_level_size(parameters.size, level);
    if (texel.x >= size.x || texel.y >= size.y) return gloam_moments_empty();
    return gloam_area_moments(texel, level, gloam_footprint(vec3(0.0, 0.0, -1.0), 1.0, this_camera()));
}

void write(ivec2 texel, int kind, vec4 value) {
    imageStore(prepared_image, gloam_pyramid_texel(texel, parameters.level, parameters.size, kind), value);
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = gloam_level_size(parameters.size, parameters.level);
    if (texel.x >= size.x || texel.y >= size.y) return;
    GloamSurfaceMoments upper = gloam_moments_add(finer(2 * texel), finer(2 * texel + ivec2(1, 0)));
    GloamSurfaceMoments lower = gloam_moments_add(finer(2 * texel + ivec2(0, 1)), finer(2 * texel + 1));
    GloamSurfaceMoments all = gloam_moments_add(upper, lower);
    write(texel, GLOAM_AREA_MEANS, vec4(all.mean, all.weight));
    write(texel, GLOAM_AREA_VARIANCES, vec4(all.variance, 0.0));
    write(texel, GLOAM_AREA_COVARIANCES, vec4(all.covariance, 0.0));
}
