// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace gloam::effect {

// The spatial filter as the library's functions have it: one invocation a pixel, each of which fetches the
// pixels that it needs. Bindings and push constants are those of spatial_filter.comp; HALF_WIDTH is to be
// defined, and one of CONVERGENCE, GEOMETRY, BILATERAL and SAO. Dispatch ceil(size / 8) groups.
inline const std::string pixel_filter = R"(#version 450
layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const bool along_y = false;
layout(constant_id = 1) const bool orthographic = false;
layout(binding = 0, r32f) uniform readonly image2D depth_image;
layout(binding = 1, GLOAM_HISTORY) uniform readonly image2D history_image;
layout(binding = 2, r32f) uniform writeonly image2D filtered_image;
layout(binding = 3, rgba32f) uniform readonly image2D normal_image;
layout(binding = 4, std430) readonly buffer Lists { uint unused[]; };
layout(binding = 5, r32f) uniform readonly image2D along_x_image;
layout(push_constant) uniform Parameters {
    vec2 p00_p11;
    ivec2 size;
    float sigma_pixels;
    float depth_scale;
    float c_adaptive;
    float weight_max;
    float cap;
} parameters;

#ifdef CONVERGENCE
#include "gloam/filter/convergence_filter.glsl"
#include "gloam/geometry/camera.glsl"
#include "gloam/temporal/convergence.glsl"
#endif
#ifdef GEOMETRY
#include "gloam/filter/geometry_blur.glsl"
#endif
#ifdef BILATERAL
#include "gloam/filter/bilateral.glsl"
#endif
#ifdef SAO
#include "gloam/filter/sao_blur.glsl"
#include "gloam/filter/weighted_mean.glsl"
#include "gloam/geometry/background.glsl"
#endif

ivec2 filter_axis() {
    return ivec2(along_y ? 0 : 1, along_y ? 1 : 0);
}

float depth_at(ivec2 pixel) {
    return imageLoad(depth_image, pixel).x;
}

float occlusion_at(ivec2 pixel) {
    return along_y ? imageLoad(along_x_image, pixel).x : imageLoad(history_image, pixel).x;
}

#ifdef CONVERGENCE
float most = 1.0;

float convergence_at(ivec2 pixel) {
    return gloam_convergence(imageLoad(history_image, pixel).y, parameters.weight_max);
}

vec2 gloam_fetch_occlusion_convergence(ivec2 pixel) {
    return vec2(occlusion_at(pixel), min(convergence_at(pixel), most));
}

vec3 gloam_fetch_position(ivec2 pixel) {
    GloamCamera camera = GloamCamera(parameters.p00_p11, parameters.size, orthographic);
    return gloam_camera_position(pixel, depth_at(pixel), camera);
}

float filtered(ivec2 pixel) {
    float own = convergence_at(pixel);
    most = own > 0.0 ? max(parameters.cap, 1.0) * own : 1.0;
    float depth = orthographic ? 1.0 : depth_at(pixel);
    float sigma = gloam_filter_sigma(depth, 1.0 / abs(parameters.p00_p11.y), float(parameters.size.y),
                                     parameters.sigma_pixels);
    return gloam_convergence_filter(pixel, filter_axis(), parameters.size, HALF_WIDTH, parameters.c_adaptive, sigma);
}
#else
float gloam_fetch_occlusion(ivec2 pixel) {
    return occlusion_at(pixel);
}
#endif

#ifdef GEOMETRY
float gloam_fetch_depth(ivec2 pixel) {
    return depth_at(pixel) / parameters.depth_scale;
}

vec3 gloam_fetch_normal(ivec2 pixel) {
    return imageLoad(normal_image, pixel).xyz;
}

float filtered(ivec2 pixel) {
    return gloam_geometry_blur(pixel, filter_axis(), parameters.size, HALF_WIDTH, vec2(10.0, 0.5));
}
#endif

#ifdef BILATERAL
float gloam_fetch_depth(ivec2 pixel) {
    return depth_at(pixel);
}

float filtered(ivec2 pixel) {
    return gloam_bilateral_filter(pixel, HALF_WIDTH * filter_axis(), parameters.size, parameters.sigma_pixels,
                                  parameters.depth_scale);
}
#endif

#ifdef SAO
float filtered(ivec2 pixel) {
    float center = depth_at(pixel);
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    if (gloam_is_background(center)) return gloam_weighted_mean_value(mean, occlusion_at(pixel));
    for (int tap = -min(HALF_WIDTH, 4); tap <= min(HALF_WIDTH, 4); ++tap) {
        ivec2 at = pixel + 2 * tap * filter_axis();
        if (at.x < 0 || at.y < 0 || at.x >= parameters.size.x || at.y >= parameters.size.y) continue;
        if (gloam_is_background(depth_at(at))) continue;
        float weight = gloam_sao_blur_weight(tap, (depth_at(at) - center) / parameters.depth_scale, 1.0);
        mean = gloam_weighted_mean_add(mean, occlusion_at(at), weight);
    }
    return gloam_weighted_mean_value(mean, occlusion_at(pixel));
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= parameters.size.x || pixel.y >= parameters.size.y) return;
    imageStore(filtered_image, pixel, vec4(filtered(pixel)));
}
)";

}  // namespace gloam::effect
