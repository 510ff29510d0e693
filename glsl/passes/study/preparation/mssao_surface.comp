// SPDX-License-Identifier: MIT
#version 450
// The surfaces of one level of MSSAO's pyramid, computed from the level before (CS-F). One invocation for each texel.
// Reads range: the largest difference in depth between pixels of one surface, world units. Writes the position and the
// normal of the pyramid's texel (gloam/gather/pixels.glsl), zeros for background.

#include "passes/study/preparation/pass.glsl"
#include "gloam/methods/mssao.glsl"

struct Surface {
    vec3 position;
    vec3 normal;
};

// A texel of the level before; zeros outside it.
Surface finer(ivec2 texel) {
    int level = parameters.level - 1;
    ivec2 size = gloam_level_size(parameters.size, level);
    if (texel.x >= size.x || texel.y >= size.y) return Surface(vec3(0.0), vec3(0.0));
    vec3 position = gloam_pyramid_position(texel, level, this_camera());
    vec3 normal = level == 0 ? GLOAM_FETCH(normal_image, texel).xyz
                             : gloam_fetch_prepared(gloam_pyramid_texel(texel, level, parameters.size,
                                                                        GLOAM_PYRAMID_NORMALS)).xyz;
    return Surface(position, normal);
}

// Combines the one or two surfaces of positive weight into one; zeros where no weight is positive.
Surface chosen(Surface surfaces[4], vec4 depths, vec4 weights) {
    int second = -1;
    int third = -1;
    for (int i = 0; i < 4; ++i) {
        if (!(weights[i] > 0.0)) continue;
        if (second < 0) {
            second = i;
        } else {
            third = i;
        }
    }
    if (second < 0) return Surface(vec3(0.0), vec3(0.0));
    if (third < 0) return Surface(surfaces[second].position, gloam_safe_normalize(surfaces[second].normal, vec3(0.0)));
    if (depths[third] < depths[second]) {
        int nearer = third;
        third = second;
        second = nearer;
    }
    return Surface(0.5 * surfaces[second].position + 0.5 * surfaces[third].position,
                   gloam_mssao_normal(surfaces[second].normal, surfaces[third].normal));
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = gloam_level_size(parameters.size, parameters.level);
    if (texel.x >= size.x || texel.y >= size.y) return;
    Surface surfaces[4];
    vec4 depths;
    for (int i = 0; i < 4; ++i) {
        surfaces[i] = finer(2 * texel + ivec2(i & 1, i >> 1));
        depths[i] = -surfaces[i].position.z;
    }
    Surface one = chosen(surfaces, depths, gloam_mssao_weights(depths, method_values.range));
    ivec2 at = gloam_pyramid_texel(texel, parameters.level, parameters.size, GLOAM_PYRAMID_POSITIONS);
    imageStore(prepared_image, at, vec4(one.position, 0.0));
    at = gloam_pyramid_texel(texel, parameters.level, parameters.size, GLOAM_PYRAMID_NORMALS);
    imageStore(prepared_image, at, vec4(one.normal, 0.0));
}
