// SPDX-License-Identifier: MIT
// G-buffer, vertices: world space in, clip and view space out.
#version 450

layout(location = 0) in vec3 world_position;
layout(location = 1) in vec3 world_normal;

layout(location = 0) out vec3 view_position;
layout(location = 1) out vec3 view_normal;

layout(push_constant) uniform Parameters {
    mat4 view;        // world to view: a rotation and a translation, so normals need no other matrix
    mat4 projection;  // view to clip
};

void main() {
    vec4 position = view * vec4(world_position, 1.0);
    view_position = position.xyz;
    view_normal = mat3(view) * world_normal;
    gl_Position = projection * position;
}
