// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_PROXY_GATHER_GLSL
#define GLOAM_OCCLUSION_PROXY_GATHER_GLSL

#include "gloam/geometry/camera.glsl"
#include "gloam/geometry/length.glsl"
#include "gloam/geometry/safe_normalize.glsl"
#include "gloam/numeric/sincos.glsl"
#include "gloam/occlusion/estimator.glsl"
#include "gloam/occlusion/further_layers.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/method_parameters.glsl"
#include "gloam/sampling/circle.glsl"
#include "gloam/sampling/halton.glsl"
#include "gloam/sampling/rotation.glsl"

// Methods in which every pixel around the shaded one stands for a piece of surface of known size, whose contributions are summed (CS-H,
// CS-S): the loop over the taps that estimate this sum. A method says what a piece contributes. Pieces behind one another all count: the sum
// is clamped, and where much is stacked it says too much.

// Defined by the user: eye-linear depth of a pixel inside the image, in world units.
float gloam_fetch_depth(ivec2 pixel);

// The piece of surface seen at a pixel.
struct GloamProxy {
    vec3 offset;  // from the shaded point, view space, world units
    vec2 size;    // of the pixel at that depth, world units
    ivec2 pixel;  // inside the image
    int layer;    // 0: what the eye sees there; 1 and more: behind it
};

// Defined by the method: what a piece contributes. normal: of the shaded point, unit.
// Returns an occlusion in [0, 1].
float gloam_method_proxy_occlusion(GloamProxy proxy, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method);

// Contribution of the piece of surface at a pixel, of the layers the largest; 0 for background, beyond the radius or for one that is not finite, and where it is no higher than the bias above the
// tangent plane.
// position, normal: of the shaded point, view space, world units; unit normal. at: inside the image.
// Error: that of the method, but for pieces within rounding of the radius or the bias.
float gloam_proxy_at(vec3 position, vec3 normal, ivec2 at, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    float occlusion = 0.0;
    for (int layer = 0; layer < GLOAM_LAYERS; ++layer) {
        float depth = layer == 0 ? gloam_fetch_depth(at) : abs(GLOAM_FURTHER_LAYER(at, layer));
        if (gloam_is_background(depth)) break;
        vec3 offset = gloam_camera_position(at, depth, camera) - position;
        bool near = gloam_length(offset) <= kernel.radius && kernel.radius <= 3.402823466e38;
        if (!(near && dot(offset, normal) > kernel.bias)) continue;
        vec2 pixels = gloam_camera_radius(kernel.radius, depth, camera) * vec2(camera.size);
        GloamProxy proxy = GloamProxy(offset, kernel.radius / pixels, at, layer);
        occlusion = max(occlusion, gloam_method_proxy_occlusion(proxy, normal, camera, kernel, method));
    }
    return occlusion;
}

// All samples of one pixel in one frame. Taps lie as 1 / distance from the pixel, for a piece counts as its inverse square, and are weighted
// so that their mean is the sum over all pixels of the disc but the shaded one, times the intensity; NaN and what is below 0 as 0.
// position: of the surface, view space, world units. normal: view space, any length.
// Returns (sum, count) for gloam_estimator_mean, the sum at most the count; outside the image the nearest pixel counts. (0, 0) where there is nothing to
// gather: background, no normal, no radius. Error: 2e-6 of each tap's share of the sum, but for taps within rounding of a pixel's border.
vec2 gloam_proxy_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    vec2 accumulated = vec2(0.0);
    if (!gloam_can_gather(position, normal, kernel.radius)) return accumulated;
    vec3 n = gloam_safe_normalize(normal, vec3(0.0));
    vec2 center = gloam_camera_uv(position, camera);
    ivec2 pixel = gloam_nearest_pixel(center, camera.size);
    vec2 reach = gloam_camera_radius(kernel.radius, -position.z, camera);
    vec2 axes = reach * vec2(camera.size);
    float pixels = 3.141592654 * axes.x * axes.y;
    vec2 turn = gloam_sincos(kernel.angle);
    for (uint i = 0u; i < kernel.count; ++i) {
        vec2 zeta = gloam_halton_2d(kernel.first + i + 1u);
        vec2 tap = gloam_turn_disc(zeta.y * gloam_circle_point(zeta.x), turn);
        ivec2 at = gloam_nearest_pixel(center + reach * tap, camera.size);
        float piece = at == pixel ? 0.0 : gloam_proxy_at(position, n, at, camera, kernel, method);
        accumulated = gloam_estimator_add(accumulated, piece > 0.0 ? 2.0 * zeta.y * pixels * piece : 0.0);
    }
    float sum = method.intensity * accumulated.x;
    return vec2(sum > 0.0 ? min(sum, accumulated.y) : 0.0, accumulated.y);
}

#endif
