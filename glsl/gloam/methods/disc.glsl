// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_DISC_GLSL
#define GLOAM_METHODS_DISC_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/occlusion/disc_taps.glsl"

// Crease shading by the surface points under a disc (TSSAO-2, -12 and -4 with the kernel of TSSAO-13; Fox and Compton
// 2008): the mean over the disc's pixels of cos(s - p, n) min(1, epsilon / |s - p|). It measures how concave the
// surface is. It looks like occlusion but is not the occlusion integral (TSSAO-1), and it depends on epsilon, 0.01 to
// 0.1 of the radius. A point beyond the radius, or no higher than the bias above the tangent plane, contributes
// nothing, because noise would decide there.
struct GloamDisc {
    float epsilon;  // world units: distance below which a patch counts fully
};

// crease shading by surface points under a disc (METHOD-disc): `mean of epsilon C(p, s_i), s_i under points of
// TSSAO-13` [TSSAO, eqs 2 and 12; Fox and Compton 2008].
// Error: 1.8e-6, but for taps within rounding of a pixel's border.
GloamEstimate gloam_disc(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamDisc settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamFootprint footprint = gloam_footprint(position, kernel.radius, camera);
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    float sum = 0.0;
    uint taken = 0u;
    for (uint i = 0u; i < kernel.count; ++i) {
        vec2 tap = gloam_turn_disc(gloam_disc_point(kernel.first + i + 1u).xy, turn);
        ivec2 at = gloam_footprint_pixel(footprint, tap);
        float depth = gloam_fetch_depth(at);
        if (gloam_tap_rejected(-position.z, depth, kernel.farthest)) continue;
        vec3 offset = gloam_footprint_position(footprint, at, depth) - position;
        float counted = gloam_contribution_fox_compton(offset, n, settings.epsilon);
        bool counts = gloam_tap_sees(depth) && dot(offset, n) > kernel.bias &&
                      dot(offset, offset) <= kernel.radius * kernel.radius;
        sum += counts ? max(counted, 0.0) : 0.0;
        ++taken;
    }
    return gloam_estimate(sum, float(taken), taken);
}

#endif
