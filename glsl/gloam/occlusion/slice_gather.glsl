// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_SLICE_GATHER_GLSL
#define GLOAM_OCCLUSION_SLICE_GATHER_GLSL

#include "gloam/geometry/camera.glsl"
#include "gloam/geometry/into_slice.glsl"
#include "gloam/geometry/safe_normalize.glsl"
#include "gloam/geometry/slice.glsl"
#include "gloam/occlusion/closed_march.glsl"
#include "gloam/occlusion/depth_rejection.glsl"
#include "gloam/occlusion/estimator.glsl"
#include "gloam/occlusion/further_layers.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/method_parameters.glsl"
#include "gloam/sampling/circle.glsl"
#include "gloam/sampling/radical_inverse.glsl"

// Methods that cut the scene by planes through the eye and march along each cut, to both sides: the loop over slices and steps. A
// method says what a slice starts from, what a step adds and what comes out.

// Defined by the user: eye-linear depth of a pixel inside the image, in world units.
float gloam_fetch_depth(ivec2 pixel);

// What a method has seen of a slice so far.
struct GloamMarch {
    vec2 positive;  // on the side of the tangent, as the method measures it
    vec2 negative;  // on the other side
    float share;    // a random number of the slice, [0, 1)
    uint sectors;   // that are covered
};

// Defined by the method: the vector that the slices have in common.
// eye: from the shaded point to the eye, unit.
vec3 gloam_method_slice_view(vec3 eye);

// Defined by the method: a slice before its first step. share: for GloamMarch.
GloamMarch gloam_method_slice_start(GloamSlice slice, vec3 normal, float share, GloamMethod method);

// Defined by the method: the slice after a step.
// offset: from the shaded point to the surface there, in the plane of the slice, world units. positive: the step's side.
GloamMarch gloam_method_slice_step(GloamMarch march, GloamSlice slice, vec3 offset, bool positive, GloamKernel kernel,
                                   GloamMethod method);

// Defined by the method: how far from the shaded point, as part of the radius, taps of a side may change a march that begins; 0: none does.
// Less than 1 of slices through the eye alone, 0 or 1 of others.
float gloam_method_slice_ball(GloamMarch march, bool positive);

// Defined by the method: whether no tap at all can change the march any more.
bool gloam_method_slice_full(GloamMarch march);

// Defined by the method: (occlusion times weight, weight) with the slice added.
vec2 gloam_method_slice_end(vec2 accumulated, GloamMarch march, GloamSlice slice, GloamMethod method);

// The point that a slice goes through.
struct GloamSlicePoint {
    vec3 position;   // view space, world units
    vec3 normal;     // unit
    vec2 direction;  // unit, in the image, y down
    float jitter;    // share of a step, [0, 1)
};

// Where a step lies, as a share of the radius: as the square of its share of the number, for horizons are made nearby. A method with other steps
// defines the macro before it includes this file; what ends marches (GLOAM_ENDS_MARCHES) knows squares alone.
#ifndef GLOAM_SLICE_STEP
#define GLOAM_SLICE_STEP(share) ((share) * (share))
#endif

// All steps of a slice, at GLOAM_SLICE_STEP((i + jitter) / steps).
// Returns the march; outside the image the nearest pixel counts. Background, the point's own pixel and what rises no higher than the bias
// above the tangent plane do not. Further layers are further steps at the same place.
GloamMarch gloam_slice_march(GloamMarch march, GloamSlice slice, GloamSlicePoint point, GloamCamera camera, GloamKernel kernel,
                             GloamMethod method) {
    vec2 center = gloam_camera_uv(point.position, camera);
    ivec2 pixel = gloam_nearest_pixel(center, camera.size);
    vec2 reach = gloam_camera_radius(kernel.radius, -point.position.z, camera) * point.direction;
    vec3 axis = cross(slice.tangent, slice.view);
    uint first = 0u;
    uint end = 2u * method.steps;
    uint by = 1u;
    if (GLOAM_ENDS_MARCHES) {
        vec2 direction = vec2(point.direction.x, camera.p00_p11.y < 0.0 ? -point.direction.y : point.direction.y);
        vec2 balls = vec2(gloam_method_slice_ball(march, true), gloam_method_slice_ball(march, false));
        vec2 ahead = gloam_slice_clearance(slice, point.position, direction, center + reach, camera, kernel.radius, balls.x);
        vec2 behind = gloam_slice_clearance(slice, point.position, direction, center - reach, camera, kernel.radius, balls.y);
        uint positive = gloam_slice_taps(ahead, balls.x, point.jitter, method.steps);
        uint negative = gloam_slice_taps(behind, balls.y, point.jitter, method.steps);
        // One tap too many changes nothing: both sides are marched as far.
        first = positive == 0u ? 1u : 0u;
        by = min(positive, negative) == 0u ? 2u : 1u;
        end = 2u * max(positive, negative);
    }
    uint i = first;
    for (; i < end && !(GLOAM_ENDS_MARCHES && gloam_method_slice_full(march)); i += by) {
        bool positive = (i & 1u) == 0u;
        float share = (float(i / 2u) + point.jitter) / float(method.steps);
        float step = GLOAM_SLICE_STEP(share);
        ivec2 at = gloam_nearest_pixel(center + (positive ? step : -step) * reach, camera.size);
        for (int layer = 0; layer < GLOAM_LAYERS; ++layer) {
            float depth = layer == 0 ? gloam_fetch_depth(at) : abs(GLOAM_FURTHER_LAYER(at, layer));
            if (at == pixel || gloam_is_background(depth)) break;
            if (GLOAM_REJECTS_TAPS && gloam_tap_rejected(-point.position.z, depth, method.range)) continue;
            vec3 seen = gloam_camera_position(at, depth, camera) - point.position;
            // Moved into a slice that nearly lies in the tangent plane, it would no longer be as high.
            if (!(dot(seen, point.normal) > kernel.bias)) continue;
            vec3 offset = gloam_into_slice(seen, axis, point.normal);
            march = gloam_method_slice_step(march, slice, offset, positive, kernel, method);
        }
    }
    GLOAM_TAPS_LEFT_OUT(2u * method.steps - (i - first) / by);
    return march;
}

// Samples that are taken where `count` are asked for: those of whole slices, of 2 steps taps each, at least one. What follows in the sequence
// begins that many samples later.
// count: k. steps: GloamMethod::steps.
// Returns a multiple of 2 max(steps, 1). Error: none.
uint gloam_slice_samples(uint count, uint steps) {
    uint taps = 2u * max(steps, 1u);
    return max(count / taps, 1u) * taps;
}

// All samples of one pixel in one frame: as many slices of 2 steps taps as kernel.count allows, at least one.
// position: of the surface, view space, world units. normal: view space, any length.
// Returns (sum, samples taken), see gloam_slice_samples, for gloam_estimator_mean, the mean being that of the slices, weighted. (0, 0) where there is nothing to
// gather: background, no normal, no radius. Error: that of the slices, 6e-5 of the sum where one nearly
// lies in the tangent plane, but for taps within rounding of a pixel's border.
vec2 gloam_slice_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    if (!gloam_can_gather(position, normal, kernel.radius)) return vec2(0.0);
    vec3 n = gloam_safe_normalize(normal, vec3(0.0));
    vec3 ahead = vec3(0.0, 0.0, 1.0);
    vec3 view = gloam_method_slice_view(camera.orthographic ? ahead : gloam_safe_normalize(-position, ahead));
    vec2 upright = vec2(1.0, camera.p00_p11.y < 0.0 ? -1.0 : 1.0);
    uint taps = 2u * max(method.steps, 1u);
    float turned = abs(kernel.angle) <= 65536.0 ? kernel.angle / 6.283185307 : 0.0;  // as gloam_sincos has it
    vec2 accumulated = vec2(0.0);
    uint taken = gloam_slice_samples(kernel.count, method.steps);
    for (uint i = 0u; i < taken / taps; ++i) {
        uint index = kernel.first / taps + i + 1u;
        // Half a turn of directions: the other half is the other side.
        vec2 direction = gloam_circle_point(0.5 * fract(gloam_radical_inverse_base2(index) + turned));
        float jitter = fract(gloam_radical_inverse(index, 3u) + turned);
        GloamSlice slice = gloam_slice(direction * upright, view, n);
        GloamMarch march = gloam_method_slice_start(slice, n, gloam_radical_inverse(index, 5u), method);
        GloamSlicePoint point = GloamSlicePoint(position, n, direction, jitter);
        march = gloam_slice_march(march, slice, point, camera, kernel, method);
        accumulated = gloam_method_slice_end(accumulated, march, slice, method);
    }
    return gloam_estimator_of_weighted(accumulated, taken);
}

#endif
