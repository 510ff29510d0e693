// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_ISSAO_GLSL
#define GLOAM_METHODS_ISSAO_GLSL

#include "gloam/geometry/covering_radius.glsl"
#include "gloam/occlusion/issao.glsl"
#include "gloam/occlusion/tap_gather.glsl"
#include "gloam/sampling/halton.glsl"
#include "gloam/sampling/issao_offset.glsl"
#include "gloam/sampling/rotation.glsl"

// ISSAO, the improved screen-space ambient occlusion, reconstructed: surface points under the circle that covers the image of a disc
// across the view ray (ISSAO-P), radii uniform (ISSAO-1, polar reading), each counting phi (v . n - psi) / (v . v + sigma) (ISSAO-6).
// Reads epsilon, the root of sigma, and intensity: lambda phi as a share of the radius; the bias is psi.

// No circle covers more than this many times the disc parallel to the screen.
const float GLOAM_ISSAO_MOST_STRETCH = 4.0;

vec2 gloam_method_tap(uint i, vec3 position, GloamKernel kernel, vec2 turn) {
    float parallel = gloam_covering_radius_parallel(position, kernel.radius, 3.402823466e38);
    float covering = gloam_covering_radius_perpendicular(position, kernel.radius, GLOAM_ISSAO_MOST_STRETCH * parallel);
    float stretch = parallel > 0.0 ? covering / parallel : 1.0;
    vec2 offset = gloam_issao_offset_polar(gloam_halton_2d(kernel.first + i + 1u).yx, stretch);
    return gloam_turn_disc(offset, turn);
}

float gloam_method_tap_occlusion(vec3 offset, vec3 normal, float depth, GloamKernel kernel, GloamMethod method) {
    float phi = method.intensity * kernel.radius;
    return gloam_contribution_issao(offset, normal, kernel.radius, phi, kernel.bias, method.epsilon * method.epsilon);
}

vec2 gloam_method_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    return gloam_tap_gather(position, normal, camera, kernel, method);
}

#endif
