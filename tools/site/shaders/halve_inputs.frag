// SPDX-License-Identifier: MIT
// passes/halve_inputs.comp as a fragment shader: of each 2 x 2 pixels of depth and normals the first one.
#include "gloam/filter/half_resolution.glsl"

layout(constant_id = 0) const bool orthographic = false;  // the camera; else perspective

struct Parameters {
    vec2 view_p00_p11;  // elements [0][0] and [1][1] of the full-size projection
    ivec2 view_size;    // of the full-size images, pixels
};
uniform Parameters parameters;
uniform sampler2D depth_image;   // eye-linear depth, world units; background 0 or not finite
uniform sampler2D normal_image;  // view-space normal that faces the eye

layout(location = 0) out vec4 depth_out;
layout(location = 1) out vec4 normal_out;  // in the view space of the half-size image

void main() {
    ivec2 source = gloam_half_source(ivec2(gl_FragCoord.xy));
    depth_out = texelFetch(depth_image, source, 0);
    vec3 normal = texelFetch(normal_image, source, 0).xyz;
    vec2 shift = vec2(gloam_half_shift(parameters.view_p00_p11.x, parameters.view_size.x),
                      gloam_half_shift(parameters.view_p00_p11.y, parameters.view_size.y));
    normal_out = vec4(orthographic ? normal : gloam_half_normal(normal, shift), 0.0);
}
