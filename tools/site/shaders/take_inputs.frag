// SPDX-License-Identifier: MIT
// passes/study/take_inputs.comp as a fragment shader: depth and normals of an engine, converted to what the other passes
// read. A projection of OpenGL has the depth range [-1, 1]; with EXT_clip_control it may have [0, 1].
#include "passes/engine_inputs.glsl"

layout(constant_id = 5) const bool has_normals = false;
layout(constant_id = 6) const bool zero_to_one = false;  // the depth range of the projection; else [-1, 1]

struct Parameters {
    mat3 view_from_world;  // a rotation
    vec2 p22_p32;          // elements [2][2] and [3][2] of the projection
};
uniform Parameters parameters;
uniform sampler2D stored_depth_image;   // depth as the engine stores it
uniform sampler2D stored_normal_image;  // normals as the engine stores them; read where has_normals is set

layout(location = 0) out vec4 depth_out;   // eye-linear depth, world units; background +infinity
layout(location = 1) out vec4 normal_out;  // view-space unit normal in xyz, 0 at the background

// Of a depth buffer whose projection has the range [-1, 1].
float linear_depth_gl(float stored, vec2 p22_p32) {
    bool reversed = p22_p32.x > 0.0;
    bool in_front_of_far_plane = reversed ? stored > 0.0 : stored < 1.0;
    if (!in_front_of_far_plane) return gloam_background_depth();
    return orthographic ? gloam_linear_depth_orthographic_gl(stored, p22_p32.x, p22_p32.y)
                        : gloam_linear_depth_perspective_gl(stored, p22_p32.x, p22_p32.y);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float stored = texelFetch(stored_depth_image, pixel, 0).x;
    float depth = depth_buffer && !zero_to_one ? linear_depth_gl(stored, parameters.p22_p32)
                                               : linear_depth(stored, parameters.p22_p32);
    depth_out = vec4(depth);
    normal_out = vec4(0.0);
    if (!has_normals || gloam_is_background(depth)) return;
    mat3 turn = parameters.view_from_world;
    mat3x4 columns = mat3x4(vec4(turn[0], 0.0), vec4(turn[1], 0.0), vec4(turn[2], 0.0));
    normal_out = vec4(view_normal(texelFetch(stored_normal_image, pixel, 0).xyz, columns), 0.0);
}
