// SPDX-License-Identifier: MIT
#ifndef GLOAM_TEMPORAL_REPROJECTED_HISTORY_GLSL
#define GLOAM_TEMPORAL_REPROJECTED_HISTORY_GLSL

#include "gloam/geometry/camera.glsl"
#include "gloam/temporal/history.glsl"

// Defined by the user: texel of the history buffer of the previous frame (gloam_history_pack), for a pixel inside it.
vec4 gloam_fetch_history(ivec2 pixel);

// history of a point, from the texels of the same surface around where it was (TSSAO-RP-history): `mean of (AO, w) over
// the four texels with |d - d'| < epsilon d, by bilinear weights; j of the heaviest` [TSSAO, eqs 7 and 8; validated
// bilinear taps].
// The index must not be interpolated.
// uv: previous texture coordinates, in [0, 1]^2. size: of the history buffer, texels. expected_depth: that the point
// had in the previous camera (gloam_previous_depth), eye-linear, world units. epsilon: relative tolerance of the
// depth, see gloam_depth_consistent; infinity accepts every surface.
// Returns the history with the expected depth; the empty one where no texel holds the surface (disoccluded), outside
// the image, and for NaN. Error of occlusion and weight: that of the fractions (gloam_texel_position) times the
// spread of the four texels, 1.6e-5 of the largest for images of 40 texels; a depth within rounding of the tolerance
// may fall to either side.
GloamHistory gloam_reprojected_history(vec2 uv, ivec2 size, float expected_depth, float epsilon) {
    if (!gloam_inside_unit(uv) || size.x < 1 || size.y < 1) return gloam_history_empty(expected_depth);
    vec2 x = gloam_texel_position(uv.x, size.x);
    vec2 y = gloam_texel_position(uv.y, size.y);
    ivec2 first = ivec2(int(x.x), int(y.x));
    vec4 texel[4];
    bvec4 valid;
    for (int i = 0; i < 4; ++i) {
        texel[i] = gloam_fetch_history(gloam_clamp_to_edge(first + ivec2(i % 2, i / 2), size));
        valid[i] = gloam_depth_consistent(texel[i].w, expected_depth, epsilon);
    }
    vec4 weights = gloam_validated_weights(gloam_bilinear_weights(vec2(x.y, y.y)), valid);
    vec4 mean = vec4(0.0, 0.0, 0.0, expected_depth);  // a texel too, with one index for all
    float most = 0.0;
    for (int i = 0; i < 4; ++i) {
        bool usable = gloam_history_usable(texel[i].x, texel[i].y);
        mean.x += usable ? weights[i] * max(texel[i].x, 0.0) : 0.0;
        mean.y += usable ? weights[i] * texel[i].y : 0.0;
        if (weights[i] > most) {
            most = weights[i];
            mean.z = usable ? texel[i].z : 0.0;
        }
    }
    mean.x = min(mean.x, 1.0);  // the weights' sum may be 1 and a rounding error
    return gloam_history_unpack(mean);
}

const uint GLOAM_TAPS_NEAREST = 0u;
const uint GLOAM_TAPS_BILINEAR = 1u;  // the four around, whatever they show, where the nearest shows the surface

// history of a point, by where it was (TSSAO-RP-point): `RP-history at (u, v) of x', d' = -z'` [TSSAO, eqs 7 and 8].
// previous: x', in the view space of the previous frame (gloam_previous_view), world units. camera: of that frame, with
// the size of the history buffer. taps: GLOAM_TAPS_*; any other number: those of the four that show the surface.
// epsilon: see gloam_reprojected_history.
// Returns the history with the depth that the point had; the empty one also for a point behind the eye. Error: as
// gloam_reprojected_history, whose coordinates err by 2e-7 here.
GloamHistory gloam_reprojected_point(vec3 previous, GloamCamera camera, uint taps, float epsilon) {
    vec2 uv = gloam_camera_uv(previous, camera);
    if (!gloam_inside_unit(uv)) return gloam_history_empty(-previous.z);
    if (taps == GLOAM_TAPS_NEAREST || taps == GLOAM_TAPS_BILINEAR) {
        vec2 center = gloam_pixel_center(uv, camera.size);
        GloamHistory nearest = gloam_reprojected_history(center, camera.size, -previous.z, epsilon);
        if (taps == GLOAM_TAPS_NEAREST || !(nearest.weight > 0.0)) return nearest;
        epsilon = gloam_background_depth();
    }
    return gloam_reprojected_history(uv, camera.size, -previous.z, epsilon);
}

#endif
