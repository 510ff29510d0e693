// SPDX-License-Identifier: MIT
#version 450
// Where the fragment is, and what it carries.
layout(location = 0) in float vertex_value;
layout(location = 0) out vec4 place;
layout(location = 1) out float value;
layout(push_constant) uniform Constants { vec2 offset; float scale; };

void main() {
    place = gl_FragCoord;
    value = scale * vertex_value;
}
