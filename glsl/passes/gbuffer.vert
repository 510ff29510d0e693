// SPDX-License-Identifier: MIT
// G-buffer, vertices: from view space to clip and view space. With GLOAM_MOTION each vertex also has its view-space
// position of the previous frame and its object.
#version 450

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
#ifdef GLOAM_MOTION
layout(location = 2) in vec3 previous_position;
layout(location = 3) in vec2 object_triangle;
#endif

layout(location = 0) out vec3 view_position;
layout(location = 1) out vec3 view_normal;
#ifdef GLOAM_MOTION
layout(location = 2) out vec3 previous_view_position;
layout(location = 3) flat out vec2 object_and_triangle;
#endif

layout(push_constant) uniform Parameters {
    mat4 projection;  // view to clip
};

void main() {
    view_position = position;
    view_normal = normal;
#ifdef GLOAM_MOTION
    previous_view_position = previous_position;
    object_and_triangle = object_triangle;
#endif
    gl_Position = projection * vec4(position, 1.0);
}
