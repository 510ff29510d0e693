// SPDX-License-Identifier: MIT
#version 450
// Bent normals and cones (Klehm et al. 2011; CS-L): the mean direction in which each point is open, and the half
// angle of the cone around it that stands for the open directions.
#include "directional/points.glsl"
#include "gloam/shading/directional.glsl"

// Side of the blocks whose pixels share a pattern (interleaved sampling): each pixel takes a part of it. 1: no sharing
layout(constant_id = 0) const int interleave = 1;

// i: number of the sample, from 0. The pixels of a block share one sequence without rotation. Each pixel takes
// consecutive points of it: these cover the half ball also where the other pixels lie on another surface.
Sample shared_sample(Shaded shaded, ivec2 pixel, uint i) {
    if (interleave == 1) return sample_of(shaded, i);
    uint part = uint(pixel.y % interleave * interleave + pixel.x % interleave);
    uint index = part * parameters.samples + i;
    return sample_at(shaded, gloam_hemisphere_uniform(gloam_halton_3d(index + 1u)));
}

// Unit direction in view space in xyz, half angle in w, radians in [0, pi / 2]. Where nothing is open: the normal and
// 0. With interleave above 1: (sum of open directions, number of them) for bent_gather.comp.
vec4 written_at(Shaded shaded, ivec2 pixel) {
    vec4 bent = vec4(0.0);
    for (uint i = 0u; i < parameters.samples; ++i) {
        Sample s = shared_sample(shaded, pixel, i);
        if (s.counts) bent = gloam_bent_add(bent, s.direction, s.visibility);
    }
    if (interleave > 1) return bent;
    return vec4(gloam_bent_normal(bent, shaded.normal), gloam_cone_angle(gloam_bent_length(bent)));
}
