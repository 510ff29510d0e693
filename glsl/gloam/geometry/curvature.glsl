// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_CURVATURE_GLSL
#define GLOAM_GEOMETRY_CURVATURE_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/square_root.glsl"

// principal curvatures from neighbouring pixels (CS-K-principal): `eigenvalues of the shape operator, -dn = S dp`
// [differential geometry].
// Principal curvatures of a surface from how position and normal change between neighbouring pixels: the eigenvalues
// of the shape operator, formed in an orthonormal frame of the tangent plane, where nothing cancels for a ball.
// position_x, position_y: changes of the position along the two axes of the image (of neighbours on the same
// surface), world units, lengths in [1e-9, 1e9]. normal_x, normal_y: changes of the unit normal over the same pixels.
// Returns (k_1, k_2), 1 / world units, the larger first; positive where the surface is concave: 1 / r on the inside
// of a ball of radius r, -1 / r on its outside. (0, 0) where the changes of the position are zero or parallel within
// 1e-4, and for what is not finite. Error: 1e-6 of the change of the normal over that of the position, for changes of
// like length more than 53 degrees apart; more as they come nearer to parallel.
vec2 gloam_principal_curvatures(vec3 position_x, vec3 position_y, vec3 normal_x, vec3 normal_y) {
    float e = dot(position_x, position_x);
    float g = dot(position_y, position_y);
    vec3 span = cross(position_x, position_y);
    float area2 = dot(span, span);
    bool spanned = e >= 1e-18 && g >= 1e-18 && e <= 1e18 && g <= 1e18 && area2 > 1e-8 * e * g;
    if (!spanned) return vec2(0.0);
    float shear = dot(position_x, position_y) / e;
    float l = -dot(position_x, normal_x);
    float m = -0.5 * (dot(position_x, normal_y) + dot(position_y, normal_x)) - shear * l;
    float n = -dot(position_y, normal_y) - shear * (2.0 * m + shear * l);
    float a = l / e;
    float b = n * (e / area2);
    float c = m / gloam_sqrt(area2);
    float half_difference = 0.5 * (a - b);
    float spread = gloam_sqrt(half_difference * half_difference + c * c);
    vec2 curvatures = vec2(0.5 * (a + b) + spread, 0.5 * (a + b) - spread);
    // The spread is infinite or less than 2^65: both are finite, or neither.
    return abs(curvatures.x) <= GLOAM_LARGEST ? curvatures : vec2(0.0);
}

#endif
