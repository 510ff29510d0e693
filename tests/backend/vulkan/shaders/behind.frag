// SPDX-License-Identifier: MIT
#version 450
// Only what lies behind the depth in an image, by the same gl_FragCoord.z.
layout(location = 0) in float vertex_value;
layout(location = 0) out vec4 place;
layout(location = 1) out float value;
layout(push_constant) uniform Constants { vec2 offset; float scale; };
layout(binding = 0, rgba32f) uniform readonly image2D peeled;

void main() {
    if (!(gl_FragCoord.z > imageLoad(peeled, ivec2(gl_FragCoord.xy)).z)) discard;
    place = gl_FragCoord;
    value = scale * vertex_value;
}
