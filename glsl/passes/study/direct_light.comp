// SPDX-License-Identifier: MIT
#version 450
// Light of the sky, from the directions in which each point is open (Ritschel, Grosch and Seidel 2009; CS-D).
#include "directional/points.glsl"
#include "gloam/shading/directional.glsl"

// Radiance in xyz, by the direction in the world, +y up: mixed between zenith and horizon by the height.
layout(binding = 4, std430) readonly buffer Sky {
    vec4 zenith;
    vec4 horizon;
    vec4 ground;  // everywhere below the horizon
} sky;

// direction: view space, unit.
vec3 sky_radiance(vec3 direction) {
    mat3x4 world = parameters.world_from_view;
    float height = dot(vec3(world[0].y, world[1].y, world[2].y), direction);
    return height > 0.0 ? mix(sky.horizon.xyz, sky.zenith.xyz, height) : sky.ground.xyz;
}

// Radiance that leaves a white surface, in xyz, in the unit of the sky.
vec4 written_at(Shaded shaded, ivec2 pixel) {
    vec3 sum = vec3(0.0);
    float count = 0.0;
    for (uint i = 0u; i < parameters.samples; ++i) {
        Sample s = sample_of(shaded, i);
        if (!s.counts) continue;
        sum += gloam_ssdo_direct(s.direction, shaded.normal, sky_radiance(s.direction), s.visibility);
        count += 1.0;
    }
    return vec4(gloam_ssdo_light(sum, count, vec3(1.0)), 0.0);
}
