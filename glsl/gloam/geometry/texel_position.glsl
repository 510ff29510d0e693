// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_TEXEL_POSITION_GLSL
#define GLOAM_GEOMETRY_TEXEL_POSITION_GLSL

// texture coordinate among the texel centres of an axis (TSSAO-RP-texel): `i + f = u n - 1/2, f in [0, 1), 0 within
// 1/256 of a centre` [definition of texture coordinates].
// u: texture coordinate in [0, 1]. extent: texels of the axis, at least 1.
// Returns (first texel, fraction in [0, 1)): the coordinate lies `fraction` of the way from the centre of the first
// texel to that of the next; -1 at the border before texel 0. Within 1/256 of a centre the fraction is 0:
// reprojection of a camera that stands still is exact to about 1e-6 and must not blur, frame by frame, into the
// neighbours. (0, 0) for u outside [0, 1] or NaN, and for an extent below 1. Error of the fraction: 6e-8 of the
// extent, and as near to 1/256 of a centre it may be taken for 0 or not.
vec2 gloam_texel_position(float u, int extent) {
    bool inside = u >= 0.0 && u <= 1.0 && extent >= 1;
    float position = u * float(extent) - 0.5;
    float first = floor(position);
    float fraction = position - first;
    bool next = fraction > 0.99609375;
    bool between = fraction >= 0.00390625 && !next;
    return inside ? vec2(next ? first + 1.0 : first, between ? fraction : 0.0) : vec2(0.0);
}

#endif
