// SPDX-License-Identifier: MIT
#version 450
// Smooths direct and bounced light in the image along one axis, by the convergence of the neighbours (TSSAO-10 and
// -11): run it along x, then along y on the result. Only for display: the history must not contain the result. One
// invocation a pixel.
//
// Dispatch ceil(size / 8) groups. Descriptor set 0:
//   0  r32f     eye-linear depth, world units; background 0 or not finite
//   1  rgba32f  direct light in xyz, accumulated samples in w
//   2  rgba32f  bounced light in xyz
//   3  rgba32f  written: as binding 1
//   4  rgba32f  written: as binding 2
#include "passes/input_image.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

layout(constant_id = 0) const bool along_y = false;
layout(constant_id = 1) const bool orthographic = false;  // else perspective
layout(constant_id = 2) const int half_width = 2;         // taps on each side

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
layout(binding = 1 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT direct_image;
layout(binding = 2 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT bounced_image;
layout(binding = 3, rgba32f) uniform writeonly highp image2D filtered_direct_image;
layout(binding = 4, rgba32f) uniform writeonly highp image2D filtered_bounced_image;

// As in spatial_filter.comp.
layout(push_constant) uniform Parameters {
    vec2 p00_p11;
    ivec2 size;
    float sigma_pixels;
    float depth_scale;
    float c_adaptive;
    float weight_max;
    float cap;
} parameters;

#include "gloam/filter/gaussian.glsl"
#include "gloam/filter/shrink.glsl"
#include "gloam/geometry/camera.glsl"
#include "gloam/temporal/convergence.glsl"

struct Tap {
    vec4 direct;
    vec4 bounced;
    vec3 position;  // view space, world units; zero for background
    float convergence;
};

Tap tap_at(ivec2 pixel) {
    Tap tap;
    tap.direct = GLOAM_FETCH(direct_image, pixel);
    tap.bounced = GLOAM_FETCH(bounced_image, pixel);
    GloamCamera camera = GloamCamera(parameters.p00_p11, parameters.size, orthographic);
    tap.position = gloam_camera_position(pixel, GLOAM_FETCH(depth_image, pixel).x, camera);
    tap.convergence = tap.position.z < 0.0 ? gloam_convergence(tap.direct.w, parameters.weight_max) : 0.0;
    return tap;
}

// Scale of the Gaussian at a pixel, 1 / world units.
float scale_at(vec3 position) {
    float tan_half_fovy = 1.0 / abs(parameters.p00_p11.y);
    return gloam_gaussian_scale(gloam_filter_sigma(orthographic ? 1.0 : -position.z, tan_half_fovy,
                                                   float(parameters.size.y), parameters.sigma_pixels));
}

// The mean of the pixel and its neighbours along the axis. own: the pixel.
Tap filtered(ivec2 pixel, Tap own, float reach) {
    float scale = scale_at(own.position);
    float most = max(parameters.cap, 1.0) * own.convergence;
    float sum = own.convergence;
    Tap mean = own;
    mean.direct.xyz *= sum;
    mean.bounced.xyz *= sum;
    for (int i = -half_width; i <= half_width; ++i) {
        ivec2 at = pixel + i * ivec2(along_y ? 0 : 1, along_y ? 1 : 0);
        bool inside = at.x >= 0 && at.y >= 0 && at.x < parameters.size.x && at.y < parameters.size.y;
        if (i == 0 || !inside) continue;
        Tap tap = tap_at(at);
        vec3 offset = tap.position - own.position;
        float weight = gloam_window_coverage(abs(i), reach) * gloam_gaussian_scaled(dot(offset, offset), scale) *
                       min(tap.convergence, most);
        mean.direct.xyz += weight * tap.direct.xyz;
        mean.bounced.xyz += weight * tap.bounced.xyz;
        sum += weight;
    }
    mean.direct.xyz /= sum;
    mean.bounced.xyz /= sum;
    return mean;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    Tap tap = tap_at(pixel);
    float reach = float(half_width) * gloam_shrink(tap.convergence, parameters.c_adaptive);
    if (reach > 0.0 && tap.convergence > 0.0) tap = filtered(pixel, tap, reach);
    imageStore(filtered_direct_image, pixel, tap.direct);
    imageStore(filtered_bounced_image, pixel, tap.bounced);
}
