// SPDX-License-Identifier: MIT
// passes/normals_from_depth.comp as a fragment shader: normals from the depth of the four neighbours.
#include "gloam/geometry/normal_from_depth.glsl"

const bool orthographic = false;  // the camera; else perspective

struct Parameters {
    vec2 p00_p11;  // elements [0][0] and [1][1] of the projection
    ivec2 size;    // of the images, pixels
};
uniform Parameters parameters;
uniform sampler2D depth_image;  // eye-linear depth, world units; background 0 or not finite

layout(location = 0) out vec4 normal_out;  // view-space unit normal that faces the eye, 0 at the background

float gloam_fetch_depth(ivec2 pixel) {
    return texelFetch(depth_image, pixel, 0).x;
}

// Of an orthographic camera; the zero vector for background and outside the image.
vec3 position_at(ivec2 pixel) {
    ivec2 size = parameters.size;
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y) return vec3(0.0);
    return gloam_view_position_orthographic(gloam_ndc_from_pixel(pixel, size), gloam_fetch_depth(pixel),
                                            parameters.p00_p11);
}

vec3 orthographic_normal(ivec2 pixel) {
    return gloam_normal_from_neighbors_orthographic(position_at(pixel), position_at(pixel - ivec2(1, 0)),
                                                    position_at(pixel + ivec2(1, 0)), position_at(pixel - ivec2(0, 1)),
                                                    position_at(pixel + ivec2(0, 1)));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 normal = orthographic ? orthographic_normal(pixel)
                               : gloam_normal_from_depth(pixel, parameters.size, parameters.p00_p11);
    normal_out = vec4(normal, 0.0);
}
