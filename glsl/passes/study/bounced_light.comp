// SPDX-License-Identifier: MIT
#version 450
// One bounce of light, from the surfaces that block to the point (Ritschel, Grosch and Seidel 2009; CS-D). Run it after
// direct_light.comp, with the same parameters. Reads the method's setting epsilon: the least distance of a sender,
// d_min.
#include "directional/points.glsl"
#include "gloam/shading/directional.glsl"

layout(binding = 4 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT albedo_image;  // diffuse, in xyz, [0, 1]
layout(binding = 5 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT direct_image;  // of direct_light.comp

// Radiance that the surface at a blocked sample sends to the point.
vec3 bounced(Shaded shaded, Sample s) {
    float depth = gloam_fetch_depth(s.pixel);
    if (gloam_is_background(depth)) return vec3(0.0);
    vec3 offset = gloam_camera_position(s.pixel, depth, this_camera()) - shaded.position;
    vec3 sender_normal = gloam_safe_normalize(GLOAM_FETCH(normal_image, s.pixel).xyz, vec3(0.0));
    vec3 sent = GLOAM_FETCH(albedo_image, s.pixel).xyz * GLOAM_FETCH(direct_image, s.pixel).xyz;
    return gloam_ssdo_bounce(offset, shaded.normal, sender_normal, sent, parameters.radius, method_values.epsilon,
                             s.visibility);
}

// Radiance that leaves a white surface by the bounce, in xyz.
vec4 written_at(Shaded shaded, ivec2 pixel) {
    vec3 sum = vec3(0.0);
    float count = 0.0;
    for (uint i = 0u; i < parameters.samples; ++i) {
        Sample s = sample_of(shaded, i);
        if (!s.counts) continue;
        if (s.visibility < 1.0) sum += bounced(shaded, s);
        count += 1.0;
    }
    return vec4(gloam_ssdo_light(sum, count, vec3(1.0)), 0.0);
}
