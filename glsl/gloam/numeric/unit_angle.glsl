// SPDX-License-Identifier: MIT
#ifndef GLOAM_NUMERIC_UNIT_ANGLE_GLSL
#define GLOAM_NUMERIC_UNIT_ANGLE_GLSL

#include "gloam/numeric/constants.glsl"

// angle of a unit vector of the upper half plane (ANGLE-unit): `atan2(y, x), y >= 0, x^2 + y^2 = 1` [minimax
// polynomial].
// Angle of a unit vector of the upper half plane, from the x axis: acos(x) and atan(y, x) in one, without a root and
// without a quotient, because both the cosine and the sine are known. It is as exact near the axes as between them,
// where acos loses half the digits. The coefficients are those of a minimax polynomial;
// Sollya's fpminimax finds as good ones.
// direction: (cosine, sine), unit, sine >= 0.
// Returns radians in [0, pi] (pi as a float). Error: 4e-7.
float gloam_unit_angle(vec2 direction) {
    float across = abs(direction.x);
    bool steep = across < direction.y;
    float m = steep ? direction.x : direction.y;
    float z = m * m;
    float p = 0.0390092656 + z * (0.0605309047 + z * (-0.0547225587 + z * 0.100911587));
    float arc = m + (m * z) * (0.166653737 + z * (0.0754709542 + z * p));
    return steep ? GLOAM_HALF_PI - arc : (direction.x < 0.0 ? GLOAM_PI - arc : arc);
}

#endif
