// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_REPROJECTION_GLSL
#define GLOAM_GEOMETRY_REPROJECTION_GLSL

#include "gloam/geometry/camera.glsl"

// Where a surface point was in the previous image (TSSAO-RP). Matrices are column-major and act on column vectors;
// "view" takes world to view space, "model" takes object to world space. Clip points stay homogeneous throughout:
// nothing is divided before the last step, so points at infinity (w = 0 in world space) are carried as well.

// texture coordinates of a clip-space point (TSSAO-RP-uv): `xy / (2 w) + 1/2, inside where |x|, |y| <= w` [TSSAO,
// reprojection].
// clip: homogeneous clip-space point. uv: texture coordinates in [0, 1]^2 with y in the direction of clip y (down in
// Vulkan); (0, 0) when the result is false.
// Returns whether the point projects into the image, borders included: false behind the camera (w below 1e-30),
// outside the image, for NaN, and for w above 2^126, where quotients are worth nothing. The verdict has no error: it
// compares |x| and |y| with w. Error of uv: at most 3 ulp.
bool gloam_uv_from_clip(vec4 clip, out vec2 uv) {
    uv = vec2(0.0);
    if (!(clip.w >= 1e-30 && clip.w <= GLOAM_LARGEST_DIVISOR)) return false;
    if (!(abs(clip.x) <= clip.w && abs(clip.y) <= clip.w)) return false;
    // A quotient of equals may be 1 and a rounding error.
    uv = min((0.5 * clip.xy + 0.5 * clip.w) / clip.w, vec2(1.0));
    return true;
}

// previous texture coordinates, static scene (TSSAO-RP): `t' = P' V' V^-1 P^-1 t` [TSSAO, reprojection].
// One matrix, prepared by the host in double: P_(f-1) V_(f-1) V_f^-1 P_f^-1.
// clip_position: clip-space point of the current frame, (ndc, 1) or homogeneous. previous_from_current: the matrix.
// uv: previous texture coordinates in [0, 1]^2; (0, 0) when the result is false.
// Returns whether the point was inside the previous image; false behind the previous camera, outside, and for NaN.
// Error of uv: 1.2e-6 for w >= 0.05 in a room of some metres; it grows with the largest products of the sums over w.
// No method or pass here calls it: it is TSSAO, the reprojection; the pass starts from view space.
bool gloam_reproject_clip(vec4 clip_position, mat4 previous_from_current, out vec2 uv) {
    return gloam_uv_from_clip(previous_from_current * clip_position, uv);
}

// previous clip-space point of a static surface point (TSSAO-RP-static): `P' V' V^-1 P^-1 t` [TSSAO, reprojection].
// clip: clip-space point of the current frame. inverse_projection, inverse_view: of the current frame.
// previous_view, previous_projection: of the previous frame.
// Returns the homogeneous point; the zero vector, which gloam_uv_from_clip rejects, where it is not finite. Error: 4
// ulp of the largest component, or 4e-4 where sums cancel whose terms add up to no more than 200 units: 2e-6 of them.
// No method or pass here calls it: it is TSSAO, the reprojection; the pass starts from view space.
vec4 gloam_previous_clip_static(vec4 clip, mat4 inverse_projection, mat4 inverse_view, mat4 previous_view,
                                mat4 previous_projection) {
    vec4 previous = previous_projection * (previous_view * (inverse_view * (inverse_projection * clip)));
    return gloam_is_finite4(previous) ? previous : vec4(0.0);
}

// previous clip-space point of a point of a moving object (TSSAO-RP-moving): `P' V' M' M^-1 V^-1 P^-1 t` [TSSAO,
// reprojection].
// (Printed without frame indices, the chain P V M M^-1 V^-1 P^-1 would be the identity.)
// clip: clip-space point of the current frame. inverse_projection, inverse_view, inverse_model: of the current frame.
// previous_model, previous_view, previous_projection: of the previous frame.
// Returns the homogeneous point; the zero vector, which gloam_uv_from_clip rejects, where it is not finite. Error: 4
// ulp of the largest component, or 5e-4 where sums cancel whose terms add up to no more than 200 units: 2.5e-6 of them.
// No method or pass here calls it: it is TSSAO, the reprojection; the pass starts from view space.
vec4 gloam_previous_clip_moving(vec4 clip, mat4 inverse_projection, mat4 inverse_view, mat4 inverse_model,
                                mat4 previous_model, mat4 previous_view, mat4 previous_projection) {
    vec4 object = inverse_model * (inverse_view * (inverse_projection * clip));
    vec4 previous = previous_projection * (previous_view * (previous_model * object));
    return gloam_is_finite4(previous) ? previous : vec4(0.0);
}

// previous world position of a point of a moving object (TSSAO-RP-world): `M' M^-1 x` [TSSAO, reprojection].
// world: current world-space position. inverse_model: of the current frame. previous_model: of the previous frame
// (both affine).
// Returns the position in world units; the zero vector where it is not finite. Error: 4 ulp of the largest component,
// or 1.2e-4 where sums cancel whose terms add up to no more than 200 units: 6e-7 of them.
// No method or pass here calls it: it is TSSAO, the reprojection; the pass reads positions in view space.
vec3 gloam_previous_world(vec3 world, mat4 inverse_model, mat4 previous_model) {
    vec4 previous = previous_model * (inverse_model * vec4(world, 1.0));
    return gloam_is_finite3(previous.xyz) ? previous.xyz : vec3(0.0);
}

// depth of a point in the previous camera (TSSAO-RP-depth): `d' = -(V' x').z` [TSSAO, reprojection].
// This, and not its depth in the current camera, is what the stored depth is compared with (TSSAO-8).
// previous_world: world-space position of the point in the previous frame. previous_view: view matrix of the previous
// frame.
// Returns the eye-linear depth in world units, negative behind the camera; 0 where it is not finite. Error: 5e-7 of
// the distances.
// No method or pass here calls it: it is TSSAO, the reprojection; the pass starts from view space.
float gloam_previous_depth(vec3 previous_world, mat4 previous_view) {
    float depth = -(previous_view * vec4(previous_world, 1.0)).z;
    return gloam_is_finite(depth) ? depth : 0.0;
}

// position relative to the previous eye (TSSAO-PREC): `q' = q + (eye - eye')` [TSSAO, precision of positions].
// Positions are stored relative to the eye because world coordinates far from the origin are coarse (at 1e5 a float's
// spacing is 0.008).
// position: q_f = x - eye_f, world axes and units. eye_delta: eye_f - eye_(f-1), subtracted in double by the host.
// Returns q_(f-1), world axes and units; the zero vector where it is not finite. Error: at most 1 ulp.
// No method or pass here calls it: it is TSSAO, the precision of positions, for engines without view-space positions.
vec3 gloam_camera_centered_previous(vec3 position, vec3 eye_delta) {
    vec3 previous = position + eye_delta;
    return gloam_is_finite3(previous) ? previous : vec3(0.0);
}

// previous position of a pixel's point, static scene (TSSAO-RP-view): `V' V^-1 x, x of CAMERA-position` [TSSAO,
// reprojection].
// In view space, where only the camera's own motion is left: world coordinates, however large, cancel in the host.
// pixel: integer pixel. depth: eye-linear, world units. camera: of this frame. previous_from_current: V' V^-1, rigid.
// Returns the position in the view space of the previous frame, world units; for background this frame's eye. Error:
// 1e-6 of the distances.
vec3 gloam_previous_view(ivec2 pixel, float depth, GloamCamera camera, mat4 previous_from_current) {
    return (previous_from_current * vec4(gloam_camera_position(pixel, depth, camera), 1.0)).xyz;
}

// previous position of a pixel's point by its motion in the image (TSSAO-RP-motion): `d (ray(p + 1/2 - m), -1), d of
// the still point` [gloam; TSSAO, reprojection].
// pixel: p. motion: m, pixels since the previous frame, x right and y down; not finite, or 1e9: it was not in the
// image. still: gloam_previous_view, as if only the camera had moved. camera: of the previous frame.
// Returns the position in the view space of the previous frame, world units. The zero vector, which is read as
// background, behind the eye, where it would not be finite, and for a point that was not in the image unless the camera
// alone has carried it in. Error: 4 ULP and 4e-6, for motions of some pixels.
// No method or pass here calls it: it is TSSAO, the reprojection by motion vectors; the pass reads positions.
vec3 gloam_previous_moved(ivec2 pixel, vec2 motion, vec3 still, GloamCamera camera) {
    vec3 previous = still;
    if (abs(motion.x) < 1e9 && abs(motion.y) < 1e9) {
        vec2 ray = (2.0 * (vec2(pixel) + 0.5 - motion) / vec2(camera.size) - 1.0) / camera.p00_p11;
        previous.xy = camera.orthographic ? ray : ray * -still.z;
    } else if (gloam_inside_unit(gloam_camera_uv(still, camera))) {
        return vec3(0.0);
    }
    bool behind = !camera.orthographic && gloam_is_background(-still.z);
    return behind || !gloam_is_finite3(previous) ? vec3(0.0) : previous;
}

#endif
