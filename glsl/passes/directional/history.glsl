// SPDX-License-Identifier: MIT
#ifndef GLOAM_DIRECTIONAL_HISTORY_GLSL
#define GLOAM_DIRECTIONAL_HISTORY_GLSL

// The history of light, kept and dropped as that of the occlusion (reproject.comp, ambient_occlusion.comp). Two images
// hold it: direct light in xyz and accumulated samples in w; bounced light in xyz and eye-linear depth in w. A pixel
// has no history where its surface has come into view (TSSAO-8). Its history counts less where the neighbourhood has
// changed (TSSAO-9 and -SI). Bindings 5 to 8 of a pass that includes this file:
//   5  buffer   a LightHistory
//   6  rgba32f  direct light and samples, of the frame before
//   7  rgba32f  bounced light and depth, of the frame before
//   8  rgba32f  xyz: where each surface point was, in the view space of the frame before; read when objects_move is 1
#include "points.glsl"
#include "gloam/geometry/borders.glsl"
#include "gloam/geometry/pixel_center.glsl"
#include "gloam/geometry/texel_position.glsl"
#include "gloam/temporal/blend.glsl"
#include "gloam/temporal/disocclusion.glsl"
#include "gloam/temporal/neighborhood.glsl"
#include "gloam/temporal/validated_bilinear.glsl"
#include "passes/invalidation.glsl"

struct LightHistory {
    mat4 previous_from_current;  // view space of this frame to that of the frame before; a rigid motion
    vec2 previous_p00_p11;       // as in Parameters, of the frame before
    uint kept;                   // 0: no history; 1: that of the same view; 2: that of the view before
    uint objects_move;           // 1: binding 8 holds the positions; 0: only the camera has moved
    uint previous_orthographic;  // 1, or 0 for perspective
    uint first_sample;           // number of the frame's first sample, from 0
    float weight_max;            // samples in the mean, at most
    float depth_tolerance;       // relative: another surface beyond it
    uint invalidation;           // as in ambient_occlusion.comp, and so are the next three
    float change_tolerance;
    float weight_small;
    float confidence_factor;
};

layout(binding = 5, std430) readonly buffer HistorySettings { LightHistory light_history; };
layout(binding = 6 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT direct_before_image;
layout(binding = 7 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT bounced_before_image;
layout(binding = 8 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT previous_position_image;

const uint SAME_VIEW = 1u;
const uint VIEW_BEFORE = 2u;

// What a pixel has of the frames before.
struct Light {
    vec3 direct;
    vec3 bounced;
    float weight;  // accumulated samples; 0: no history
};

// Where the pixel's surface was, in the view space of the frame before. position: in that of this frame.
vec3 previous_position_at(ivec2 pixel, vec3 position) {
    if (light_history.objects_move != 0u) return GLOAM_FETCH(previous_position_image, pixel).xyz;
    return (light_history.previous_from_current * vec4(position, 1.0)).xyz;
}

// The mean of the four texels around a position that show the same surface. uv: in the image before, [0, 1]^2.
Light light_at(vec2 uv, float expected_depth) {
    vec2 x = gloam_texel_position(uv.x, parameters.size.x);
    vec2 y = gloam_texel_position(uv.y, parameters.size.y);
    vec4 direct[4];
    vec4 bounced[4];
    bvec4 valid;
    for (int i = 0; i < 4; ++i) {
        ivec2 texel = gloam_clamp_to_edge(ivec2(int(x.x), int(y.x)) + ivec2(i % 2, i / 2), parameters.size);
        direct[i] = GLOAM_FETCH(direct_before_image, texel);
        bounced[i] = GLOAM_FETCH(bounced_before_image, texel);
        valid[i] = gloam_depth_consistent(bounced[i].w, expected_depth, light_history.depth_tolerance);
    }
    vec4 weights = gloam_validated_weights(gloam_bilinear_weights(vec2(x.y, y.y)), valid);
    Light mean = Light(vec3(0.0), vec3(0.0), 0.0);
    for (int i = 0; i < 4; ++i) {
        mean.direct += weights[i] * direct[i].xyz;
        mean.bounced += weights[i] * bounced[i].xyz;
        mean.weight += weights[i] * direct[i].w;
    }
    return mean;
}

// previous: where the pixel's surface was, in the view space of the frame before.
Light light_before(ivec2 pixel, vec3 previous) {
    if (light_history.kept == SAME_VIEW) {
        vec4 direct = GLOAM_FETCH(direct_before_image, pixel);
        return Light(direct.xyz, GLOAM_FETCH(bounced_before_image, pixel).xyz, direct.w);
    }
    Light none = Light(vec3(0.0), vec3(0.0), 0.0);
    if (light_history.kept != VIEW_BEFORE || gloam_is_background(-previous.z)) return none;
    GloamCamera camera =
        GloamCamera(light_history.previous_p00_p11, parameters.size, light_history.previous_orthographic != 0u);
    vec2 uv = gloam_camera_uv(previous, camera);
    return gloam_inside_unit(uv) ? light_at(uv, -previous.z) : none;
}

// How much the distance to the surface under a sample has changed, world units. previous: where the shaded point was.
float change_of(Shaded shaded, vec3 previous, ivec2 pixel) {
    float depth = gloam_fetch_depth(pixel);
    if (light_history.objects_move == 0u || gloam_is_background(depth)) return 0.0;
    vec3 now = gloam_camera_position(pixel, depth, this_camera());
    vec3 then = GLOAM_FETCH(previous_position_image, pixel).xyz;
    float reach = parameters.radius + method_values.range;
    bool near = distance(now, shaded.position) <= reach || distance(then, previous) <= reach;
    if (!near || !gloam_probe_useful(now - shaded.position, shaded.normal)) return 0.0;
    return gloam_neighborhood_change(now, shaded.position, then, previous);
}

// Samples of the history that count after the largest change among the samples, world units.
float weight_after_change(float weight, float change) {
    return invalidated_weight(weight, change, parameters.radius, light_history.invalidation,
                              light_history.change_tolerance, light_history.weight_small,
                              light_history.confidence_factor);
}

// The mean of the history and of `count` new samples (TSSAO-5). fresh: their mean. weight: of the history, samples.
vec3 blended_light(vec3 before, float weight, vec3 fresh, float count) {
    float share = gloam_blend(0.0, weight, 1.0, count, light_history.weight_max).x;
    return before + share * (fresh - before);
}

// Samples in that mean.
float blended_weight(float weight, float count) {
    return gloam_blend(0.0, weight, 1.0, count, light_history.weight_max).y;
}

#endif
