// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_HEMISPHERE_GATHER_GLSL
#define GLOAM_OCCLUSION_HEMISPHERE_GATHER_GLSL

#include "gloam/geometry/camera.glsl"
#include "gloam/geometry/plane_depth.glsl"
#include "gloam/occlusion/blocked.glsl"
#include "gloam/occlusion/estimator.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/ritschel.glsl"
#include "gloam/sampling/halton.glsl"
#include "gloam/sampling/hemisphere.glsl"
#include "gloam/sampling/rotation.glsl"
#include "gloam/sampling/tangent_frame.glsl"

// Ambient occlusion of one pixel by points in the half ball above it (TSSAO-2, -3 and -4 with the kernel of TSSAO-14; Ritschel et
// al. 2009). Cosine-weighted directions of uniform radius need neither cosine nor falloff: the mean of the plain blocked
// tests estimates TSSAO-1 with the linear falloff, for a scene that is solid behind what the eye sees.

// Defined by the user: eye-linear depth of a pixel inside the image, in world units.
float gloam_fetch_depth(ivec2 pixel);

// One sample point.
// accumulated: (sum, count) so far. position: view space, world units. frame: columns tangent, bitangent, normal.
// range: see gloam_sample_blocked. index: number of the Halton point.
// The sample's depth is taken where its pixel was: moved to the pixel's centre along the plane parallel to the surface, so that a bare
// plane is open at any tilt.
// Returns (sum, count) with the sample added: 1 where blocked, 0 where open and where its pixel is background; outside the image
// the nearest pixel counts. Unchanged for a point at or behind the eye, one that is not finite, and one at the centre (index 0).
// Error: none, but a point within rounding of a pixel's border or of the blocking depth may fall to either side.
vec2 gloam_hemisphere_tap(vec2 accumulated, vec3 position, mat3 frame, GloamCamera camera, GloamKernel kernel, float range,
                          uint index) {
    vec3 point = gloam_rotate_hemisphere(gloam_hemisphere_cosine(gloam_halton_3d(index)), kernel.angle);
    vec3 at = position + kernel.radius * (frame * point);
    if (point == vec3(0.0) || gloam_is_background(-at.z) || !gloam_is_finite2(at.xy)) return accumulated;
    ivec2 pixel = gloam_nearest_pixel(gloam_camera_uv(at, camera), camera.size);
    float depth = gloam_plane_depth(pixel, at, frame[2], camera);
    float blocked = gloam_sample_blocked(depth, gloam_fetch_depth(pixel), kernel.bias, range);
    return gloam_estimator_add(accumulated, gloam_contribution_cosine_directions(blocked, 1.0));
}

// All samples of one pixel in one frame.
// position: of the surface, view space, world units. normal: view space, any length. range: world units, about the radius, or
// infinity; see gloam_sample_blocked.
// Returns (sum, count) for gloam_estimator_mean; count may be below kernel.count (see above), and is 0 where there is nothing to
// gather: background, no normal, no radius. Error: none, but for points within rounding, as above.
vec2 gloam_hemisphere_gather(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, float range) {
    vec2 accumulated = vec2(0.0);
    if (!gloam_can_gather(position, normal, kernel.radius)) return accumulated;
    mat3 frame = gloam_tangent_frame(normal);
    for (uint i = 0u; i < kernel.count; ++i) {
        accumulated = gloam_hemisphere_tap(accumulated, position, frame, camera, kernel, range, kernel.first + i + 1u);
    }
    return accumulated;
}

#endif
