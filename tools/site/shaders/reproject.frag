// SPDX-License-Identifier: MIT
// passes/study/reproject.comp as a fragment shader, for a camera that moves among surfaces that stand still: brings the
// history of the previous frame to the pixels of this one.
#include "gloam/geometry/camera.glsl"
#include "gloam/temporal/reprojected_history.glsl"

layout(constant_id = 0) const bool orthographic = false;  // the camera of both frames; else perspective

struct Parameters {
    mat4 previous_from_current;  // view space of this frame to that of the previous one
    vec2 p00_p11;                // elements [0][0] and [1][1] of this frame's projection
    vec2 previous_p00_p11;       // of the previous frame's
    ivec2 size;                  // of all images, pixels
    float tolerance;             // of the depth test, relative
};
uniform Parameters parameters;
uniform sampler2D depth_image;       // eye-linear depth of this frame; background 0
uniform sampler2D previous_history;  // (occlusion, samples accumulated, samples of the sequence used, depth)

layout(location = 0) out vec4 history;

vec4 gloam_fetch_history(ivec2 pixel) {
    return texelFetch(previous_history, pixel, 0);
}

GloamHistory reprojected(ivec2 pixel) {
    float depth = texelFetch(depth_image, pixel, 0).x;
    if (gloam_is_background(depth)) return gloam_history_empty(depth);
    GloamCamera camera = GloamCamera(parameters.p00_p11, parameters.size, orthographic);
    vec3 position = gloam_camera_position(pixel, depth, camera);
    vec3 previous = (parameters.previous_from_current * vec4(position, 1.0)).xyz;
    GloamCamera before = GloamCamera(parameters.previous_p00_p11, parameters.size, orthographic);
    vec2 uv = gloam_camera_uv(previous, before);
    if (gloam_is_background(-previous.z) || !gloam_inside_unit(uv)) return gloam_history_empty(depth);
    return gloam_reprojected_history(uv, parameters.size, -previous.z, parameters.tolerance);
}

void main() {
    history = gloam_history_pack(reprojected(ivec2(gl_FragCoord.xy)));
}
