// SPDX-License-Identifier: MIT
// G-buffer, fragments: eye-linear depth from the value that goes into the depth buffer, and the view-space normal.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "gloam/geometry/linear_depth.glsl"
#include "gloam/geometry/safe_normalize.glsl"

layout(location = 0) in vec3 view_position;
layout(location = 1) in vec3 view_normal;

layout(location = 0) out float linear_depth;
layout(location = 1) out vec4 normal;

layout(push_constant) uniform Parameters {
    mat4 view;
    mat4 projection;
};

void main() {
    float b = gl_FragCoord.z;
    bool orthographic = projection[2][3] == 0.0;
    linear_depth = orthographic ? gloam_linear_depth_orthographic_vk(b, projection[2][2], projection[3][2])
                                : gloam_linear_depth_perspective_vk(b, projection[2][2], projection[3][2]);
    vec3 n = gloam_safe_normalize(view_normal, vec3(0.0, 0.0, 1.0));
    vec3 toward_viewer = orthographic ? vec3(0.0, 0.0, 1.0) : -view_position;
    normal = vec4(dot(n, toward_viewer) < 0.0 ? -n : n, 0.0);
}
