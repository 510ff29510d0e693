// SPDX-License-Identifier: MIT
#version 450
// Gathers the directions of interleaved sampling (Klehm et al. 2011; CS-L). Each of the pixels that share a pattern
// took a part of the samples (bent_normals.comp). This pass adds up a block of that size around each pixel, which holds
// every part once. A neighbour counts as far as it lies on the same surface.
// Run it after bent_normals.comp with the same interleave.
#include "directional/points.glsl"
#include "gloam/filter/weights.glsl"
#include "gloam/shading/directional.glsl"

layout(constant_id = 0) const int interleave = 4;  // side of the blocks whose pixels share a pattern

layout(binding = 4 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT sums_image;  // what bent_normals.comp wrote

// Weight of a neighbour, [0, 1]: 1 on the tangent plane with the same normal, 0 for background.
float weight_of(Shaded shaded, ivec2 at) {
    float depth = gloam_fetch_depth(at);
    if (gloam_is_background(depth)) return 0.0;
    vec3 offset = gloam_camera_position(at, depth, this_camera()) - shaded.position;
    vec3 normal = gloam_safe_normalize(GLOAM_FETCH(normal_image, at).xyz, vec3(0.0));
    float height = dot(offset, shaded.normal) / (0.1 * parameters.radius);  // over the tangent plane
    return gloam_geometry_weight(shaded.normal, normal, height, 10.0, 8.0);
}

// As bent_normals.comp without interleave.
vec4 written_at(Shaded shaded, ivec2 pixel) {
    vec4 bent = vec4(0.0);
    for (int i = 0; i < interleave * interleave; ++i) {
        ivec2 at = pixel + ivec2(i % interleave, i / interleave) - interleave / 2;
        if (at.x < 0 || at.y < 0 || at.x >= parameters.size.x || at.y >= parameters.size.y) continue;
        float weight = at == pixel ? 1.0 : weight_of(shaded, at);
        bent += weight * GLOAM_FETCH(sums_image, at);
    }
    return vec4(gloam_bent_normal(bent, shaded.normal), gloam_cone_angle(gloam_bent_length(bent)));
}
