// SPDX-License-Identifier: MIT
#ifndef GLOAM_FILTER_QUAD_BOX_GLSL
#define GLOAM_FILTER_QUAD_BOX_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/occlusion/visibility.glsl"

// mean of the two pixels of a quad along one axis (CS-Q-quad): `A - dA ((x & 1) - 1/2), if |dz| < edge` [McGuire, Mara
// and Luebke 2012 (Scalable Ambient Obscurance)].
// Mean of the two pixels of a quad along one axis, from the screen-space derivative of a fragment (SAO): A - dA ((x &
// 1) - 1/2), unless a depth edge lies between them. Applied along x and then along y, with the y difference of the new
// values, it is the mean of the quad.
// visibility: A of the pixel, [0, 1]. difference: that of the odd pixel minus that of the even one, dFdx(A).
// depth_difference: the same of the depth, world units. coordinate: of the pixel along the axis; its lowest bit alone
// counts. edge: largest depth difference that is still smoothed over, world units: 0.02 m.
// Returns visibility in [0, 1]; A itself (1 for NaN) at an edge and where a difference is NaN. Error: 1e-7.
// No method or pass here calls it: it is there to be copied.
float gloam_quad_box(float visibility, float difference, float depth_difference, int coordinate, float edge) {
    bool smooth_here = abs(depth_difference) < edge && abs(difference) <= GLOAM_LARGEST;
    float side = (coordinate & 1) == 1 ? 0.5 : -0.5;
    return gloam_visibility_clamp(smooth_here ? visibility - difference * side : visibility);
}

#endif
