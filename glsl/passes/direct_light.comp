// SPDX-License-Identifier: MIT
#version 450
// Light from an environment, from the directions in which each point is open (Ritschel, Grosch and Seidel 2009;
// CS-D), in the mean over frames. One invocation a pixel.
//
// Dispatch ceil(size / 8) groups. Descriptor set 0: see directional/points.glsl and directional/history.glsl, and
//   4  rgba32f  written: radiance that leaves a white surface in xyz, in the unit of the environment; 0 at the
//               background. w: accumulated samples
//   9  rgba32f  radiance of the environment in xyz, over directions of the world: columns are longitudes, -z in the
//               middle and +x to the right of it, rows polar angles from +y; each texel is one value
#include "directional/history.glsl"
#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/inverse_trigonometry.glsl"
#include "gloam/shading/directional_occlusion.glsl"

layout(binding = 4, rgba32f) uniform writeonly highp image2D light_image;
layout(binding = 9 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT environment_image;

// direction: view space, unit.
vec3 environment(vec3 direction) {
    vec3 world =
        mat3(parameters.world_from_view[0].xyz, parameters.world_from_view[1].xyz, parameters.world_from_view[2].xyz) *
        direction;
    ivec2 size = GLOAM_INPUT_SIZE(environment_image);
    vec2 at = vec2(0.5 + gloam_atan2(world.x, -world.z) / GLOAM_TAU, gloam_acos(world.y) / GLOAM_PI);
    return GLOAM_FETCH(environment_image, clamp(ivec2(at * vec2(size)), ivec2(0), size - 1)).xyz;
}

// The mean with this frame's samples: radiance in xyz, samples in w.
vec4 accumulated(ivec2 pixel, Shaded shaded) {
    vec3 previous = previous_position_at(pixel, shaded.position);
    Light before = light_before(pixel, previous);
    vec3 sum = vec3(0.0);
    float count = 0.0;
    float change = 0.0;
    for (uint i = 0u; i < parameters.samples; ++i) {
        Sample s = sample_of(shaded, light_history.first_sample + i);
        if (!s.counts) continue;
        sum += gloam_ssdo_direct(s.direction, shaded.normal, environment(s.direction), s.visibility);
        count += 1.0;
        change = max(change, change_of(shaded, previous, s.pixel));
    }
    float weight = weight_after_change(before.weight, change);
    vec3 fresh = gloam_ssdo_light(sum, count, vec3(1.0));
    return vec4(blended_light(before.direct, weight, fresh, count), blended_weight(weight, count));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    Shaded shaded;
    vec4 light = vec4(0.0);
    if (shaded_at(pixel, shaded)) light = accumulated(pixel, shaded);
    imageStore(light_image, pixel, light);
}
