// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_HEIGHT_AT_GLSL
#define GLOAM_GEOMETRY_HEIGHT_AT_GLSL

#include "gloam/geometry/finite.glsl"

// height of the surface of a tap at the aimed place (PAIR-height): `((s - p - a) . n) / (v . n)` [definition].
// How far along the view vector from an aimed place the surface lies that is as high over the tangent plane as what
// was seen.
// offset: from the shaded point to what was seen. aim: from there to the place, in the plane of the image; world
// units. view, normal: unit.
// Returns a length in world units, ((offset - aim) . n) / (view . n), the divisor at least 1e-4; 0 where it is not
// finite. Error: 3.5e-7 of the offset over view . n.
// No method or pass here calls it: it is there to be copied.
float gloam_height_at(vec3 offset, vec3 aim, vec3 view, vec3 normal) {
    float facing = dot(view, normal);
    float height = dot(offset - aim, normal) / (facing <= 1e-4 ? 1e-4 : facing);  // NaN stays, which max() may drop
    return gloam_is_finite(height) ? height : 0.0;
}

#endif
