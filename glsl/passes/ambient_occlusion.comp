// SPDX-License-Identifier: MIT
#version 450
// Ambient occlusion of one frame, blended into the history (TSSAO-2 to -6, -12 to -14, BUF, ROT): one invocation a pixel. The history
// is that of the same pixel: move it first (reprojection) where the view has changed.
//
// Dispatch ceil(size / 8) groups. Descriptor set 0:
//   0  r32f     eye-linear depth, world units; background 0 or not finite
//   1  rgba32f  view-space normal facing the eye in xyz
//   2  rgba32f  history before: (occlusion, samples accumulated, samples of the sequence used, depth); zeros for none
//   3  rgba32f  written: history after, likewise; background (0, 0, 0, infinity)
//   4  buffer   written when count_work is set: for each group (samples taken, pixels of background, pixels whose radius is below
//               the limit, pixels of the group); else never touched
layout(local_size_x = 8, local_size_y = 8) in;

layout(constant_id = 0) const uint method = 0u;         // 0: points in the hemisphere (TSSAO-3), 1: disc (TSSAO-12)
layout(constant_id = 1) const bool count_work = false;  // fill binding 4

layout(binding = 0, r32f) uniform readonly image2D depth_image;
layout(binding = 1, rgba32f) uniform readonly image2D normal_image;
layout(binding = 2, rgba32f) uniform readonly image2D history_before;
layout(binding = 3, rgba32f) uniform writeonly image2D history_after;
layout(binding = 4, std430) writeonly buffer Work { uvec4 work[]; };

layout(push_constant) uniform Parameters {
    vec2 p00_p11;          // elements [0][0] and [1][1] of the projection, y down
    ivec2 size;            // of the images, pixels
    float radius;          // of influence, world units
    float bias;            // world units
    float range;           // hemisphere: blockers further in front than this are other objects; world units
    float epsilon;         // disc: distance at which a patch counts fully, world units
    uint samples;          // k, for each pixel
    uint table_size;       // samples after which the sequence starts over
    float weight_max;      // w_max: samples in the mean, at most
    float c_rot;           // kernels are rotated below this convergence; 0 never
    float least_radius;    // pixels: where the projected radius is smaller, occlusion is 0 without a sample; 0 never
    uint orthographic;     // 1, or 0 for perspective
    uint skip_background;  // 1: background returns at once; 0: it goes the long way, with the same result
} parameters;

#include "gloam/geometry/camera.glsl"
#include "gloam/occlusion/disc_gather.glsl"
#include "gloam/occlusion/hemisphere_gather.glsl"
#include "gloam/sampling/hash_rotation.glsl"
#include "gloam/temporal/blend.glsl"
#include "gloam/temporal/convergence.glsl"
#include "gloam/temporal/history.glsl"
#include "gloam/temporal/rotation_switch.glsl"

shared uint counted[4];

const uint TAKEN = 0u;
const uint BACKGROUND = 1u;
const uint BELOW_LIMIT = 2u;
const uint PIXELS = 3u;

float gloam_fetch_depth(ivec2 pixel) {
    return imageLoad(depth_image, pixel).x;
}

void count(uint what, uint amount) {
    if (count_work && amount > 0u) atomicAdd(counted[what], amount);
}

// (sum, count) of this frame's samples.
vec2 gather(ivec2 pixel, float depth, GloamHistory before, GloamCamera camera) {
    float convergence = gloam_convergence(before.weight, parameters.weight_max);
    float angle = gloam_rotation_enabled(convergence, parameters.c_rot) ? gloam_hash_rotation(pixel) : 0.0;
    GloamKernel kernel = GloamKernel(parameters.radius, parameters.bias, angle, before.index, parameters.samples);
    vec3 position = gloam_camera_position(pixel, depth, camera);
    vec3 normal = imageLoad(normal_image, pixel).xyz;
    return method == 0u ? gloam_hemisphere_gather(position, normal, camera, kernel, parameters.range)
                        : gloam_disc_gather(position, normal, camera, kernel, parameters.epsilon);
}

GloamHistory shade(ivec2 pixel) {
    float depth = gloam_fetch_depth(pixel);
    bool background = gloam_is_background(depth);
    count(PIXELS, 1u);
    count(BACKGROUND, background ? 1u : 0u);
    if (background && parameters.skip_background != 0u) return gloam_history_empty(depth);

    GloamCamera camera = GloamCamera(parameters.p00_p11, parameters.size, parameters.orthographic != 0u);
    vec2 reach = gloam_camera_radius(parameters.radius, depth, camera) * vec2(parameters.size);
    if (!background && max(reach.x, reach.y) < parameters.least_radius) {
        count(BELOW_LIMIT, 1u);
        return GloamHistory(0.0, parameters.weight_max, 0u, depth);  // known for certain: converged
    }

    GloamHistory before = gloam_history_unpack(imageLoad(history_before, pixel));
    vec2 fresh = gather(pixel, depth, before, camera);
    count(TAKEN, uint(fresh.y));
    vec2 blended =
        gloam_blend(before.occlusion, before.weight, gloam_estimator_mean(fresh), fresh.y, parameters.weight_max);
    uint next = gloam_next_index(before.index, parameters.samples, parameters.table_size);
    return GloamHistory(blended.x, blended.y, next, depth);
}

void main() {
    if (count_work) {
        if (gl_LocalInvocationIndex < 4u) counted[gl_LocalInvocationIndex] = 0u;
        barrier();
    }
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x < parameters.size.x && pixel.y < parameters.size.y) {
        imageStore(history_after, pixel, gloam_history_pack(shade(pixel)));
    }
    if (count_work) {
        barrier();
        uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
        if (gl_LocalInvocationIndex == 0u) {
            work[group] = uvec4(counted[TAKEN], counted[BACKGROUND], counted[BELOW_LIMIT], counted[PIXELS]);
        }
    }
}
