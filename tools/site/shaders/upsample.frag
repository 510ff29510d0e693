// SPDX-License-Identifier: MIT
// passes/upsample.comp as a fragment shader: occlusion at the view's size from that of half-size passes.
#include "gloam/filter/half_resolution.glsl"
#include "gloam/filter/upsample.glsl"

layout(constant_id = 0) const bool orthographic = false;  // the camera; else perspective

struct Parameters {
    ivec2 view_size;  // of the full-size images, pixels
};
uniform Parameters parameters;
uniform sampler2D depth_image;       // eye-linear depth, world units; background 0 or not finite
uniform sampler2D half_depth_image;  // the same at half the size
uniform sampler2D source_image;      // occlusion in x at half the size

layout(location = 0) out vec4 upsampled;  // the occlusion in x; 0 at the background

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 first = pixel / 2;
    ivec2 next = min(first + pixel % 2, gloam_half_size(parameters.view_size) - 1);
    ivec2 right = ivec2(next.x, first.y);
    ivec2 below = ivec2(first.x, next.y);
    vec4 depths = vec4(texelFetch(half_depth_image, first, 0).x, texelFetch(half_depth_image, right, 0).x,
                       texelFetch(half_depth_image, below, 0).x, texelFetch(half_depth_image, next, 0).x);
    vec4 occlusions = vec4(texelFetch(source_image, first, 0).x, texelFetch(source_image, right, 0).x,
                           texelFetch(source_image, below, 0).x, texelFetch(source_image, next, 0).x);
    upsampled = vec4(gloam_upsample(texelFetch(depth_image, pixel, 0).x, depths, occlusions, orthographic));
}
