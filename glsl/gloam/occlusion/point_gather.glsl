// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_POINT_GATHER_GLSL
#define GLOAM_OCCLUSION_POINT_GATHER_GLSL

#include "gloam/geometry/camera.glsl"
#include "gloam/geometry/plane_depth.glsl"
#include "gloam/numeric/sincos.glsl"
#include "gloam/occlusion/depth_rejection.glsl"
#include "gloam/occlusion/estimator.glsl"
#include "gloam/occlusion/further_layers.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/method_parameters.glsl"
#include "gloam/sampling/tangent_frame.glsl"

// Methods that compare points of the space around a pixel with the depth buffer (TSSAO-2 to -4): the loop over the points. A method
// says where they lie and what one of them contributes.

// Defined by the user: eye-linear depth of a pixel inside the image, in world units.
float gloam_fetch_depth(ivec2 pixel);

// Defined by the method: a point of the unit ball.
// index: number of the Halton point, 1 for the first. turn: (cos, sin) of the kernel's angle.
// Returns the point in tangent space, z along the normal; the zero vector for none.
vec3 gloam_method_point(uint index, vec2 turn);

// Defined by the method: what a point contributes.
// depth: of the point, moved to the centre of its pixel along the plane parallel to the surface, so that a bare plane is the same at
// any tilt. buffer_depth: what the eye sees there; both eye-linear, world units.
// Returns an occlusion; background blocks nothing.
float gloam_method_point_occlusion(float depth, float buffer_depth, GloamKernel kernel, GloamMethod method);

// One sample point. With further layers a point behind the back of what is in front of it is open: no guess of a thickness is needed. What is
// behind the last layer nobody knows: of three or more, a back that is the last closes nothing.
// accumulated: (sum, count) so far. position: view space, world units. frame: columns tangent, bitangent, normal.
// point: of the unit ball, of gloam_method_point.
// Returns (sum, count) with the sample added; outside the image the nearest pixel counts. Unchanged for a point at or
// behind the eye, one that is not finite, and one at the centre.
// Error: none, but a point within rounding of a pixel's border or of the blocking depth may fall to either side.
vec2 gloam_point_tap(vec2 accumulated, vec3 position, mat3 frame, GloamCamera camera, GloamKernel kernel, GloamMethod method,
                     vec3 point) {
    vec3 at = position + kernel.radius * (frame * point);
    if (point == vec3(0.0) || gloam_is_background(-at.z) || !gloam_is_finite2(at.xy)) return accumulated;
    ivec2 pixel = gloam_nearest_pixel(gloam_camera_uv(at, camera), camera.size);
    float seen = gloam_fetch_depth(pixel);
    if (GLOAM_REJECTS_TAPS && gloam_tap_rejected(-position.z, seen, method.range)) return accumulated;
    float depth = gloam_plane_depth(pixel, at, frame[2], camera);
    float occlusion = gloam_method_point_occlusion(depth, seen, kernel, method);
    bool front = true;  // what the eye sees
    float before = 0.0;
    for (int layer = 1; layer < GLOAM_LAYERS; ++layer) {
        float next = GLOAM_FURTHER_LAYER(pixel, layer);
        bool closes = front && next < 0.0;
        bool known = layer + 1 < GLOAM_LAYERS || GLOAM_LAYERS == 2;
        if (closes && known && -next < depth) occlusion = before;
        before = occlusion;
        if (!closes) occlusion = max(occlusion, gloam_method_point_occlusion(depth, abs(next), kernel, method));
        front = next > 0.0;
    }
    return gloam_estimator_add(accumulated, occlusion);
}

// All samples of one pixel in one frame.
// position: of the surface, view space, world units. normal: view space, any length.
// Returns (sum, count) for gloam_estimator_mean; count may be below kernel.count (see above), and is 0 where there is nothing to
// gather: background, no normal, no radius. Error: none, but for points within rounding, as above.
vec2 gloam_point_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamMethod method) {
    vec2 accumulated = vec2(0.0);
    if (!gloam_can_gather(position, normal, kernel.radius)) return accumulated;
    mat3 frame = gloam_tangent_frame(normal);
    vec2 turn = gloam_sincos(kernel.angle);
    for (uint i = 0u; i < kernel.count; ++i) {
        vec3 point = gloam_method_point(kernel.first + i + 1u, turn);
        accumulated = gloam_point_tap(accumulated, position, frame, camera, kernel, method, point);
    }
    return accumulated;
}

#endif
