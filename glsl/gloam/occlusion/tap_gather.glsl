// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_TAP_GATHER_GLSL
#define GLOAM_OCCLUSION_TAP_GATHER_GLSL

#include "gloam/geometry/camera.glsl"
#include "gloam/geometry/safe_normalize.glsl"
#include "gloam/numeric/sincos.glsl"
#include "gloam/occlusion/depth_rejection.glsl"
#include "gloam/occlusion/estimator.glsl"
#include "gloam/occlusion/further_layers.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/method_parameters.glsl"
#include "gloam/sampling/tap_pixel.glsl"

// Methods that look at the surface points under a disc around the pixel: the loop over the taps. A method says where in the disc they
// lie and what the surface seen there contributes.

// Defined by the user: eye-linear depth of a pixel inside the image, in world units.
float gloam_fetch_depth(ivec2 pixel);

// Defined by the method: a tap, in units of the projected radius.
// i: number of the tap in this frame, from 0. position: of the shaded point, view space, world units. turn: GLOAM_KERNEL_TURN of the kernel.
vec2 gloam_method_tap(uint i, vec3 position, GloamKernel kernel, vec2 turn);

// (cos, sin) by which all taps of a pixel are turned. A method that turns them by more than the kernel's angle declares a function with this
// parameter and defines the macro as its name, before it includes this file.
#ifndef GLOAM_KERNEL_TURN
#define GLOAM_KERNEL_TURN(kernel) gloam_sincos(kernel.angle)
#endif

// Defined by the method: what the surface seen at a tap contributes.
// offset: from the shaded point to it, view space, world units. normal: of the shaded point, unit. depth: of the shaded point,
// eye-linear, world units.
// Returns an occlusion, finite and at least 0, scaled so that the mean over the taps, clamped to 1, is the result.
float gloam_method_tap_occlusion(vec3 offset, vec3 normal, float depth, GloamKernel kernel, GloamMethod method);

// Contribution of the surface at a pixel, of the layers the largest; 0 for background.
// position, normal: of the shaded point, view space, world units; unit normal. at: inside the image.
float gloam_tap_at(vec3 position, vec3 normal, ivec2 at, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    float depth = gloam_fetch_depth(at);
    if (gloam_is_background(depth)) return 0.0;
    vec3 offset = gloam_camera_position(at, depth, camera) - position;
    float occlusion = gloam_method_tap_occlusion(offset, normal, -position.z, kernel, method);
    for (int layer = 1; layer < GLOAM_LAYERS; ++layer) {
        depth = abs(GLOAM_FURTHER_LAYER(at, layer));
        if (gloam_is_background(depth)) break;
        offset = gloam_camera_position(at, depth, camera) - position;
        occlusion = max(occlusion, gloam_method_tap_occlusion(offset, normal, -position.z, kernel, method));
    }
    return occlusion;
}

// Contribution of a tap: what the depth chain has at its place, read in the full image. A method that reads the chain in an image of its own
// declares a function with these parameters and defines GLOAM_TAP as its name, before it includes this file.
// p, n: position and normal, as above. aimed: where the tap lies. pixel: of the shaded point, both inside the image. k, m: kernel and method.
#ifndef GLOAM_TAP
#define GLOAM_TAP(p, n, aimed, pixel, camera, k, m) gloam_tap_at(p, n, gloam_tap_pixel(aimed, pixel, camera.size, m.mip_distance), camera, k, m)
#endif

// All samples of one pixel in one frame.
// position: of the surface, view space, world units. normal: view space, any length.
// Returns (sum, count) for gloam_estimator_mean; outside the image the nearest pixel counts. (0, 0) where there is nothing to
// gather: background, no normal, no radius. Error: that of the contributions, but for taps within rounding of a pixel's border.
vec2 gloam_tap_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    vec2 accumulated = vec2(0.0);
    if (!gloam_can_gather(position, normal, kernel.radius)) return accumulated;
    vec3 n = gloam_safe_normalize(normal, vec3(0.0));
    vec2 center = gloam_camera_uv(position, camera);
    ivec2 pixel = gloam_nearest_pixel(center, camera.size);
    vec2 reach = gloam_camera_radius(kernel.radius, -position.z, camera);
    vec2 turn = GLOAM_KERNEL_TURN(kernel);
    for (uint i = 0u; i < kernel.count; ++i) {
        ivec2 aimed = gloam_nearest_pixel(center + reach * gloam_method_tap(i, position, kernel, turn), camera.size);
        if (GLOAM_REJECTS_TAPS) {
            ivec2 at = gloam_tap_pixel(aimed, pixel, camera.size, method.mip_distance);
            if (gloam_tap_rejected(-position.z, gloam_fetch_depth(at), method.range)) continue;
        }
        accumulated = gloam_estimator_add(accumulated, GLOAM_TAP(position, n, aimed, pixel, camera, kernel, method));
    }
    return accumulated;
}

#endif
