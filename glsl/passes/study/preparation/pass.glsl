// SPDX-License-Identifier: MIT
#ifndef GLOAM_PREPARATION_PASS_GLSL
#define GLOAM_PREPARATION_PASS_GLSL

// The common part of the preparation passes. They run before ambient_occlusion.comp, in the order of their method's
// list. Each writes a part of one image, which the method reads by gloam_fetch_prepared. The image keeps nothing from
// frame to frame.
//
// Define GLOAM_PREPARED as r32f for the passes whose image has one
// channel (first_direction.comp, depth_chain.comp, disc_visibility.comp); the default is rgba32f.
// Dispatch ceil(invocations / 8) groups; each pass says how many invocations. Descriptor set 0:
//   0  r32f     eye-linear depth, world units; background 0 or not finite
//   1  rgba32f  view-space normal facing the eye in xyz
//   2  rgba32f  history before, at the pixels of this frame: (occlusion, samples accumulated, samples of the sequence
//               used, depth)
//   3  prepared the prepared image, written
//   4  buffer   a MethodValues
//   5  rgba32f  depth layers 1 to 3 behind binding 0 in xyz, as ambient_occlusion.comp has them; read when layers is
//               more than 1
//   6  prepared the image of binding 3: read by passes that build on others, where earlier passes have written
#include "passes/study/input_image.glsl"
#ifndef GLOAM_PREPARED
#define GLOAM_PREPARED rgba32f
#endif
layout(local_size_x = 8, local_size_y = 8) in;

layout(constant_id = 0) const int layers = 1;               // depth layers that the samples see, 1 to 4
// skip taps further in front than MethodValues::range (CS-REJ)
layout(constant_id = 1) const bool reject_taps = false;
layout(constant_id = 2) const bool keeps_history = true;    // false: each frame stands by itself
layout(constant_id = 3) const uint samples_asked = 32u;      // k_1, for each pixel that has not converged
layout(constant_id = 4) const uint samples_converged = 16u;  // k_2, for each pixel that has
layout(constant_id = 5) const uint method_steps = 4u;        // replaces MethodValues::steps
layout(constant_id = 6) const bool on_lattice = false;      // kernels are rotated on a lattice; else by a hash
const bool fewer_samples = true;
const bool caps_radius = true;

layout(binding = 0 GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT depth_image;
layout(binding = 1 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT normal_image;
layout(binding = 2 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT history_before;
layout(binding = 3, GLOAM_PREPARED) uniform writeonly highp image2D prepared_image;

layout(push_constant) uniform Parameters {
    vec2 p00_p11;          // elements [0][0] and [1][1] of the projection, y down
    ivec2 size;            // of the images of bindings 0 to 2, pixels, with the guard band
    ivec2 border;          // guard band on each side, pixels
    float radius;          // of influence, world units
    float bias;            // world units
    float c_spatial;       // convergence from which a pixel takes k_2; above 1: never
    float weight_max;      // w_max: largest number of samples in the mean
    float c_rot;           // kernels are rotated below this convergence; 0: never
    float least_radius;    // pixels: where the projected radius is smaller, occlusion is 0 without a sample; 0: off
    uint orthographic;     // 1, or 0 for perspective
    uint shade_border;     // 1: the band has occlusion as well; 0: it is skipped
    float samples_distance;  // of the far plane, world units: fewer samples the further away (CS-N); 0: as many
                             // everywhere
    float samples_radius;    // pixels: fewer samples where the projected radius is smaller (ISSAO-LOD); 0: as many
                             // everywhere
    uint samples_least;    // least number that these two leave
    float radius_cap;      // pixels: largest projected radius (Gears of War 2)
    float bias_depth;      // the bias is at least this share of the depth
    int level;             // that the pass writes, 1 for half the resolution; of passes that run once for each level
} parameters;

#include "gloam/geometry/borders.glsl"
#include "gloam/geometry/camera.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/temporal/history.glsl"
#include "passes/study/method_values.glsl"

layout(binding = 4, std430) readonly buffer MethodSettings { MethodValues method_values; };
layout(binding = 5 GLOAM_FORMAT(rgba32f)) uniform GLOAM_INPUT layer_image;
layout(binding = 6 GLOAM_FORMAT(GLOAM_PREPARED)) uniform GLOAM_INPUT earlier_image;

vec3 gloam_fetch_layers(ivec2 pixel) {
    return GLOAM_FETCH(layer_image, pixel).xyz;
}

GloamCamera this_camera() {
    return GloamCamera(parameters.p00_p11, parameters.size, parameters.orthographic != 0u);
}

#include "../pixel_samples.glsl"

float gloam_fetch_depth(ivec2 pixel) {
    return GLOAM_FETCH(depth_image, pixel).x;
}

// The samples that ambient_occlusion.comp takes at a pixel in this frame.
GloamKernel kernel_at(ivec2 pixel) {
    float depth = gloam_fetch_depth(pixel);
    GloamHistory before = gloam_history_empty(0.0);
    if (keeps_history) before = gloam_history_unpack(GLOAM_FETCH(history_before, pixel));
    return kernel_of(pixel, depth, before, samples_at(before, depth));
}

// Whether a surface at that depth is open without a sample, because its projected radius is below the limit.
bool below_limit(float depth) {
    vec2 reach = reach_at(depth);
    return max(reach.x, reach.y) < parameters.least_radius;
}

// Whether no pixel of the frame is within this distance. Such a pixel is read by the guard band only.
bool far_from_frame(ivec2 pixel, int pixels) {
    if (parameters.shade_border != 0u) return false;
    ivec2 inner = pixel - parameters.border;
    ivec2 apart = abs(inner - gloam_clamp_to_edge(inner, parameters.size - 2 * parameters.border));
    return max(apart.x, apart.y) > pixels;
}

#endif
