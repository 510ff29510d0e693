// SPDX-License-Identifier: MIT
// passes/study/normals_from_depth.comp as a fragment shader: normals from the depth of the four neighbours.
#include "gloam/geometry/camera_normal.glsl"

layout(constant_id = 0) const bool orthographic = false;  // the camera; else perspective

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

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    GloamCamera camera = GloamCamera(parameters.p00_p11, parameters.size, orthographic);
    normal_out = vec4(gloam_camera_normal(pixel, camera), 0.0);
}
