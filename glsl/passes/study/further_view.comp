// SPDX-License-Identifier: MIT
#version 450
// Ambient occlusion from a further view (CS-LAYERS, multiple views). Another camera may see surfaces that are hidden in
// this view. The pass estimates the occlusion of each surface point a second time, in the depth buffer of another
// camera that sees the point, and keeps the larger result.
// Run the pass once for each further view.
//
// A point that the other camera does not see keeps its occlusion, because the thickness of what hides it there is
// unknown.
// Define METHOD and change the include to use another method than the one below; methods with preparation passes cannot
// be used.
#include "passes/study/input_image.glsl"

layout(constant_id = 0) const bool orthographic = false;        // this camera; else perspective
layout(constant_id = 1) const bool other_orthographic = false;  // the other one
layout(constant_id = 2) const uint samples = 32u;               // for each pixel, whole units of the method
layout(constant_id = 3) const uint method_steps = 4u;           // replaces MethodValues::steps

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
layout(binding = 1 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT normal_image;
layout(binding = 2 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT other_depth_image;  // of the other view, in its space
layout(binding = 3 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT other_normal_image;
layout(binding = 4, r32f) uniform highp image2D occlusion_image;  // [0, 1]: written where it becomes larger

layout(push_constant) uniform Parameters {
    mat4 other_from_this;   // this view space to that of the other camera
    vec2 p00_p11;           // elements [0][0] and [1][1] of this projection, y down
    vec2 other_p00_p11;     // of the other one
    ivec2 size;             // of this view, pixels
    ivec2 other_size;       // of the other one
    float radius;           // of influence, world units
    float bias;             // world units
} parameters;

#include "gloam/gather/footprint.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/sampling/rotation.glsl"
#include "gloam/temporal/history.glsl"
#include "method_values.glsl"

layout(binding = 5, std430) readonly buffer MethodSettings { MethodValues method_values; };

// Largest difference between the point's depth and the other view's surface at which both are one surface, as a share
// of the depth.
const float SEEN_TOLERANCE = 0.02;

// The images that the method reads: those of the other view.
float gloam_fetch_depth(ivec2 pixel) {
    return GLOAM_FETCH(other_depth_image, pixel).x;
}

vec3 gloam_fetch_normal(ivec2 pixel) {
    return GLOAM_FETCH(other_normal_image, pixel).xyz;
}

vec3 gloam_fetch_layers(ivec2 pixel) {
    return vec3(0.0);
}

vec4 gloam_fetch_prepared(ivec2 pixel) {
    return vec4(0.0);
}

// The method: any file of that folder, and a call of it. values: a MethodValues.
#include "gloam/methods/hemisphere.glsl"
#ifndef METHOD
#define METHOD(position, normal, camera, kernel, values) \
    gloam_hemisphere(position, normal, camera, kernel, GloamHemisphere(values.range, values.layers))
#endif

// Whether the other camera sees this point, from the front. position, normal: in that camera's view space.
bool seen_there(vec3 position, vec3 normal, GloamCamera camera) {
    if (!(-position.z >= 1e-18 && -position.z <= GLOAM_FARTHEST)) return false;
    if (!(dot(normal, gloam_toward_eye(position, camera.orthographic)) > 0.0)) return false;
    vec2 uv = gloam_camera_uv(position, camera);
    if (!(uv.x >= 0.0 && uv.y >= 0.0 && uv.x <= 1.0 && uv.y <= 1.0)) return false;
    float depth = gloam_fetch_depth(gloam_nearest_pixel(uv, camera.size));
    return gloam_depth_consistent(depth, -position.z, SEEN_TOLERANCE);
}

// Occlusion of a pixel's point in the other view; 0 where the other view cannot estimate it.
float occlusion_there(ivec2 pixel, float depth) {
    vec3 here = gloam_camera_position(pixel, depth, GloamCamera(parameters.p00_p11, parameters.size, orthographic));
    vec3 position = (parameters.other_from_this * vec4(here, 1.0)).xyz;
    vec3 normal = mat3(parameters.other_from_this) * GLOAM_FETCH(normal_image, pixel).xyz;
    GloamCamera camera = GloamCamera(parameters.other_p00_p11, parameters.other_size, other_orthographic);
    if (!seen_there(position, normal, camera)) return 0.0;
    GloamKernel kernel = GloamKernel(parameters.radius, parameters.bias, gloam_hash_rotation(pixel), 0u, samples,
                                     uintBitsToFloat(0x7F800000u));
    MethodValues values = method_values;
    values.steps = method_steps;
    values.layers = 1;
    GloamEstimate found = METHOD(position, normal, camera, kernel, values);
    return found.samples > 0.0 ? found.occlusion : 0.0;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    float depth = GLOAM_FETCH(depth_image, pixel).x;
    if (gloam_is_background(depth)) return;
    float before = imageLoad(occlusion_image, pixel).x;
    float there = occlusion_there(pixel, depth);
    if (there > before) imageStore(occlusion_image, pixel, vec4(there));
}
