// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_MSSAO_GLSL
#define GLOAM_METHODS_MSSAO_GLSL

#include "gloam/occlusion/method_parameters.glsl"
#include "passes/preparation/mssao_level.glsl"

// Multi-resolution ambient occlusion (Hoang and Low 2010, 2012): surface points under small discs at several resolutions, each disc twice
// as wide as the one before. The coarser resolutions are prepared (preparation/mssao_surface.comp, mssao_level.comp); here is the finest.
// Reads steps: the number of resolutions, at most 9, and range: how far apart in depth the pixels of one surface may be.

// All samples of one pixel in one frame: kernel.count at every resolution.
// position: of the surface, view space, world units. normal: view space, any length.
// Returns (sum, kernel.count) for gloam_estimator_mean. (0, 0) where there is nothing to gather: background, no normal, no radius.
vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    if (!gloam_can_gather(position, normal, kernel.radius)) return vec2(0.0);
    vec3 n = gloam_safe_normalize(normal, vec3(0.0));
    GloamLevels levels = gloam_mssao_at(position, n, 0, camera, kernel, gloam_coarsest_level(method.steps));
    return float(kernel.count) * vec2(gloam_mssao_combine(levels.largest, levels.mean), 1.0);
}

#endif
