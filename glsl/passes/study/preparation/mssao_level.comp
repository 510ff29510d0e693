// SPDX-License-Identifier: MIT
#version 450
// The occlusion of one level of MSSAO (CS-F), combined with that of the coarser levels, which earlier runs have
// written. One invocation for each texel. Writes (largest occlusion of the levels so far, their mean, their number)
// into the pyramid's results.

#include "passes/study/preparation/pass.glsl"
#include "gloam/methods/mssao.glsl"

// The pixel at the middle of a texel. Its history determines which samples come next.
ivec2 middle(ivec2 texel) {
    return min((texel << parameters.level) + (1 << (parameters.level - 1)), parameters.size - 1);
}

// The kernel of a texel. depth: of the texel's surface, which can differ from that of the middle pixel.
GloamKernel texel_kernel(ivec2 texel, float depth) {
    GloamKernel kernel = kernel_at(middle(texel));
    kernel.radius = radius_at(depth);
    if (kernel.angle != 0.0) kernel.angle = gloam_hash_rotation(texel);
    return kernel;
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = gloam_level_size(parameters.size, parameters.level);
    if (texel.x >= size.x || texel.y >= size.y) return;
    int coarsest = gloam_coarsest_level(method_steps);
    vec3 position = gloam_pyramid_position(texel, parameters.level, this_camera());
    vec3 normal = gloam_fetch_prepared(gloam_pyramid_texel(texel, parameters.level, parameters.size,
                                                           GLOAM_PYRAMID_NORMALS)).xyz;
    GloamLevels levels = GloamLevels(0.0, 0.0, 0.0);
    if (gloam_can_gather(position, normal, parameters.radius, this_camera())) {
        levels = gloam_mssao_at(position, normal, parameters.level, this_camera(), texel_kernel(texel, -position.z),
                                coarsest);
    }
    ivec2 at = gloam_pyramid_texel(texel, parameters.level, parameters.size, GLOAM_PYRAMID_RESULTS);
    imageStore(prepared_image, at, vec4(levels.largest, levels.mean, levels.count, 0.0));
}
