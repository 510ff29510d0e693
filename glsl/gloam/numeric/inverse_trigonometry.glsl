// SPDX-License-Identifier: MIT
#ifndef GLOAM_NUMERIC_INVERSE_TRIGONOMETRY_GLSL
#define GLOAM_NUMERIC_INVERSE_TRIGONOMETRY_GLSL

#include "gloam/numeric/arithmetic.glsl"

// arc cosine, cubic approximation (CS-P-acos-cubic): `((-2 pi / 9) x^2 - 5 pi / 18) x + pi / 2` [Mittring 2012; Aalund
// and Baerentzen 2013].
// As the angle-based method of UE4 has it: right at -1, -1/2, 0, 1/2 and 1, up to 0.178758 rad (10.2 degrees) from
// acos, at |x| = 0.9275. The copy at hand prints its first constant as -0-69813.
// x: cosine; taken to the nearer end outside [-1, 1], NaN to 0.
// Returns radians in [0, pi]. Error against its own formula: 4e-7.
// No method or pass here calls it: it is the angle of the comparative study; the methods take gloam_unit_angle.
float gloam_acos_cubic(float x) {
    float c = abs(x) <= 1.0 ? x : (x > 1.0 ? 1.0 : (x < -1.0 ? -1.0 : 0.0));
    return clamp((-0.6981317008 * (c * c) - 0.8726646260) * c + GLOAM_HALF_PI, 0.0, GLOAM_PI);
}

// angle of a unit vector of the upper half plane (ANGLE-unit): `atan2(y, x), y >= 0, x^2 + y^2 = 1` [minimax
// polynomial].
// From the x axis: acos(x) and atan(y, x) in one, without a root and without a quotient, because both the cosine and
// the sine are known. It is as exact near the axes as between them, where acos loses half the digits.
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

// Inverse trigonometric functions. Vulkan lets those of the device err by 4096 ulp, 2e-4 at the least; the error of
// these stays below 1e-6 on every conforming driver that does their operations in order (`precise`, NoContraction).
// A driver that reorders all that Vulkan lets it may err by 2e-4; none is known to. The coefficients are those of
// minimax polynomials; Sollya's fpminimax finds as good ones.

// arc sine near 0 (ASIN-half): `asin x, |x| <= 1/2` [minimax polynomial].
// x: in [-1/2, 1/2]; beyond, the polynomial parts from the function.
// Returns radians. Error: 2 ulp whatever the rounding, 1 ulp where it is to nearest.
float gloam_asin_half(float x) {
    float z = x * x;
    return x +
           (x * z) * (0.166667521 + z * (0.0749529749 + z * (0.0454703756 + z * (0.0241795145 + z * 0.0421663076))));
}

// magnitude of a sine or cosine (UNIT-magnitude): `min(|x|, 1); 0 for NaN` [minimax polynomial].
// x: any float.
// Returns |x|, at most 1; 0 for NaN. Error: none.
float gloam_unit_magnitude(float x) {
    float magnitude = abs(x);
    return magnitude <= 1.0 ? magnitude : (magnitude > 1.0 ? 1.0 : 0.0);
}

// arc sine, or half the arc cosine, of m (SMALL-ARC): `asin m for m <= 1/2, else acos(m) / 2` [minimax polynomial].
// Half the arc cosine is asin(sqrt((1 - m) / 2)): both angles are small.
// m: in [0, 1].
// Returns radians in [0, pi / 6]. Error: 4e-7 whatever the rounding, 1.5e-7 where it is to nearest.
float gloam_small_arc(float m) {
    GLOAM_PRECISE float half_rest = 0.5 * (1.0 - m);
    return gloam_asin_half(m > 0.5 ? gloam_sqrt(half_rest) : m);
}

// arc cosine (ACOS): `acos x` [minimax polynomial].
// x: cosine; taken to the nearer end outside [-1, 1].
// Returns radians in [0, pi] (pi as a float); pi / 2 for NaN. 0 exactly at 1.
// Error: 1e-6 whatever the rounding, 4e-7 where it is to nearest.
float gloam_acos(float x) {
    float m = gloam_unit_magnitude(x);
    float arc = gloam_small_arc(m);
    if (m > 0.5) return x < 0.0 ? GLOAM_PI - 2.0 * arc : 2.0 * arc;
    return GLOAM_HALF_PI - (x < 0.0 ? -arc : arc);
}

// direction of a point (ATAN2): `angle of (x, y), counter-clockwise from the x axis; 0 at the origin` [minimax
// polynomial].
// y, x: coordinates; subnormal ones may be read as 0. Note the order, that of atan(y, x).
// Returns radians in [-pi, pi] (pi as a float); pi on the negative x axis whatever the sign of y = 0; multiples of pi
// / 4 where both are infinite. 0 where both are zero or subnormal, and where either is NaN.
// Error: 1e-6 whatever the rounding, 3e-7 where it is to nearest.
float gloam_atan2(float y, float x) {
    float across = abs(x);
    float up = abs(y);
    bool steep = up > across;
    float larger = steep ? up : across;
    float smaller = steep ? across : up;
    if (!(larger >= GLOAM_SMALLEST && smaller >= 0.0)) return 0.0;
    float r = gloam_length_ratio(smaller, larger);
    float z = r * r;
    float tail = -0.0755221471 + z * (0.0432118662 + z * (-0.0163679309 + z * 0.00292069302));
    float angle = r + (r * z) * (-0.333331525 + z * (0.199937731 + z * (-0.142110556 + z * (0.106660046 + z * tail))));
    if (steep) {
        angle = x < 0.0 ? GLOAM_HALF_PI + angle : GLOAM_HALF_PI - angle;
    } else if (x < 0.0) {
        angle = GLOAM_PI - angle;
    }
    return y < 0.0 ? -angle : angle;
}

// arc tangent (ATAN): `atan x` [minimax polynomial].
// x: any float.
// Returns radians in [-pi / 2, pi / 2]; 0 for NaN. Error: 1e-6 whatever the rounding, 2e-7 where it is to nearest.
float gloam_atan(float x) {
    return gloam_atan2(x, 1.0);
}

#endif
