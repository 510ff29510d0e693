// SPDX-License-Identifier: MIT
#version 450
// Light of the sky, from the directions in which each point is open (Ritschel, Grosch and Seidel 2009; CS-D).
#include "directional/points.glsl"
#include "gloam/shading/directional.glsl"

// Radiance that leaves a white surface, in xyz, in the unit of the sky; 0 at the background.
layout(binding = 3, rgba32f) uniform writeonly highp image2D light_image;

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

vec3 light_of(Shaded shaded) {
    vec3 sum = vec3(0.0);
    float count = 0.0;
    for (uint i = 0u; i < parameters.samples; ++i) {
        Sample s = sample_of(shaded, i);
        if (!s.counts) continue;
        sum += gloam_ssdo_direct(s.direction, shaded.normal, sky_radiance(s.direction), s.visibility);
        count += 1.0;
    }
    return gloam_ssdo_light(sum, count, vec3(1.0));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    Shaded shaded;
    vec3 light = vec3(0.0);
    if (shaded_at(pixel, shaded)) light = light_of(shaded);
    imageStore(light_image, pixel, vec4(light, 0.0));
}
