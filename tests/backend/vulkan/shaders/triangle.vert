// SPDX-License-Identifier: MIT
#version 450
layout(location = 0) in vec3 position;
layout(location = 1) in float value;
layout(location = 0) out float vertex_value;
layout(push_constant) uniform Constants { vec2 offset; float scale; };

void main() {
    gl_Position = vec4(position.xy + offset, position.z, 1.0);
    vertex_value = value;
}
