// SPDX-License-Identifier: MIT
// One more depth layer, fragments: the nearest surface behind the previous layer (depth peeling; Bavoil and Sainz
// 2009).
// Run the pass once for each layer, with gbuffer.vert and always the same pipeline, on the output of the run before. A
// surface then has a bit-identical depth in every run, and no surface is found twice.
//
// The comparison is exact: surfaces of equal depth form one layer, nearly coincident surfaces form two.
//   0  rgba32f  of the run before: (depth, value of the depth buffer, 0, 1 where there is a surface); for the first run
//               (0, 2, 0, 1) with reversed depth, else (0, -1, 0, 1)
// The output has the same four values and is cleared to 0. Its depth is eye-linear, negative where the surface is seen
// from behind, 0 where there is none.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "gloam/geometry/background.glsl"
#include "gloam/geometry/linear_depth.glsl"
#include "gloam/geometry/safe_normalize.glsl"

layout(location = 0) in vec3 view_position;
layout(location = 1) in vec3 view_normal;
layout(location = 0) out vec4 layer;

layout(binding = 0, rgba32f) uniform readonly image2D layer_before;

layout(push_constant) uniform Parameters {
    mat4 projection;
    uint reversed_z;  // 1, or 0 where the depth buffer grows with the distance
};

// Whether the viewer sees the back: the mesh's normal points to the outer side. away: unit, from the viewer.
bool seen_from_behind(vec3 away) {
    vec3 flat_normal = gloam_safe_normalize(cross(dFdx(view_position), dFdy(view_position)), -away);
    if (dot(flat_normal, away) > 0.0) flat_normal = -flat_normal;
    return dot(view_normal, flat_normal) < 0.0;
}

void main() {
    float b = gl_FragCoord.z;
    bool orthographic = projection[2][3] == 0.0;
    bool back = seen_from_behind(orthographic ? vec3(0.0, 0.0, -1.0)
                                              : gloam_safe_normalize(view_position, vec3(0.0, 0.0, -1.0)));
    float depth = orthographic ? gloam_linear_depth_orthographic_vk(b, projection[2][2], projection[3][2])
                               : gloam_linear_depth_perspective_vk(b, projection[2][2], projection[3][2]);
    vec4 before = imageLoad(layer_before, ivec2(gl_FragCoord.xy));
    bool behind = reversed_z != 0u ? b < before.y : b > before.y;
    if (!(before.w > 0.0 && behind)) discard;
    if (gloam_is_background(depth)) depth = 0.0;
    layer = vec4(back ? -depth : depth, b, 0.0, 1.0);
}
