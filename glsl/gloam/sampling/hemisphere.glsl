// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_HEMISPHERE_GLSL
#define GLOAM_SAMPLING_HEMISPHERE_GLSL

#include "gloam/geometry/vector.glsl"
#include "gloam/sampling/disc.glsl"

// point of the half ball: cosine-weighted direction, uniform radius (TSSAO-14): `a = 2 pi zeta_x, r = zeta_y; s = r
// (cos a sqrt(1 - zeta_z), sin a sqrt(1 - zeta_z), sqrt(zeta_z))` [TSSAO, eq 14 corrected; Ritschel's kernel].
// zeta: uniform point of [0, 1)^3 (a Halton point); coordinates outside are taken to the nearer end, NaN to 0.
// Returns a point s in tangent space (z along the normal), |s| = zeta_y, s.z >= 0. Directions have density cos / pi, so
// an average over samples carries no further cosine. zeta_y = 0 gives the zero vector, which has no direction: skip it.
// Error: 3e-7.
vec3 gloam_hemisphere_cosine(vec3 zeta) {
    float radius = gloam_unit_interval(zeta.y);
    float cosine_squared = gloam_unit_interval(zeta.z);
    return radius * vec3(gloam_sqrt(1.0 - cosine_squared) * gloam_circle_point(zeta.x), gloam_sqrt(cosine_squared));
}

// point of the half ball: uniform direction, uniform radius (TSSAO-14-uniform): `a = 2 pi zeta_x, r = zeta_y; s = r
// (cos a sqrt(1 - zeta_z^2), sin a sqrt(1 - zeta_z^2), zeta_z)` [TSSAO, variant of eq 14].
// zeta: uniform point of [0, 1)^3 (a Halton point); coordinates outside are taken to the nearer end, NaN to 0.
// Returns a point s in tangent space (z along the normal), |s| = zeta_y, s.z >= 0. Directions have density 1 / (2 pi),
// so an average over samples carries the cosine and a factor 2. zeta_y = 0 gives the zero vector: skip it. Error: 3e-7.
vec3 gloam_hemisphere_uniform(vec3 zeta) {
    float radius = gloam_unit_interval(zeta.y);
    float cosine = gloam_unit_interval(zeta.z);
    return radius * vec3(gloam_sqrt((1.0 - cosine) * (1.0 + cosine)) * gloam_circle_point(zeta.x), cosine);
}

// point of a sample: hemisphere_cosine (POINTS-hemisphere-cosine): `TSSAO-14 of the Halton point` [TSSAO, eqs 13 and
// 14].
// index: number of the Halton point, 1 for the first. Returns the point in tangent space, z along the normal. Error:
// 1.2e-6 where the third coordinate of the Halton point is below 0.998; up to 5e-4 beyond, where the square root
// magnifies the error of that coordinate.
vec3 gloam_hemisphere_cosine_point(uint index) {
    return gloam_hemisphere_cosine(gloam_halton_3d(index));
}

// point of a sample: hemisphere_uniform (POINTS-hemisphere-uniform): `TSSAO-14-uniform of the Halton point` [TSSAO, eqs
// 13 and 14].
// index: number of the Halton point, 1 for the first. Returns the point in tangent space, z along the normal. Error:
// 2e-6 where the third coordinate of the Halton point is below 0.998; up to 5e-4 beyond, where the square root
// magnifies the error of that coordinate.
vec3 gloam_hemisphere_uniform_point(uint index) {
    return gloam_hemisphere_uniform(gloam_halton_3d(index));
}

// sample brought into the hemisphere of a normal (FLIP): `s if s . n > 0, else -s` [Filion and McNaughton 2008].
// What is uniform on the sphere stays uniform on the hemisphere.
// s: sample point, in the space of the normal, in units of the kernel radius (length below 1e19).
// normal: direction, of any length below 1e19.
// Returns s or -s; -s where s . n = 0, as faceforward(s, s, -n) does, and where the normal is NaN; the zero vector
// for a longer, infinite or NaN s. Error: none, but for the sign of an s within rounding of the tangent plane.
// No method or pass here calls it: it is the flip of the comparative study; the methods draw half balls.
vec3 gloam_hemisphere_flip(vec3 s, vec3 normal) {
    if (!(dot(s, s) <= 1e38)) return vec3(0.0);
    return dot(s, normal) > 0.0 ? s : -s;
}

// orthonormal frame around a normal (FRAME): `columns t, b, n: z turned onto n the shortest way` [Duff et al. 2017].
// Right-handed, without branches that lose accuracy near any direction. The tangents jump where n.z changes its sign.
// normal: n, unit, in any space.
// Returns the matrix of columns (t, b, n), t x b = n: it takes tangent space (z along the normal) to the space of the
// normal. Its first two columns are the axes x and y for a zero normal; NaN for a NaN normal. Error: 3e-7 in each
// component.
mat3 gloam_tangent_frame(vec3 n) {
    float side = n.z < 0.0 ? -1.0 : 1.0;
    float a = -1.0 / (side + n.z);
    float b = n.x * n.y * a;
    // A name for the product: NVIDIA's OpenGL 580 negates the bits of -side * n.x as an integer.
    float x = side * n.x;
    vec3 tangent = vec3(1.0 + x * n.x * a, side * b, -x);
    vec3 bitangent = vec3(b, side + n.y * n.y * a, -n.y);
    return mat3(tangent, bitangent, n);
}

// sample reflected at a random plane (REFLECT): `s - 2 (s . n) n, n = normalize(2 t - 1)` [Mittring 2007].
// s: sample point in any space, in units of the kernel radius (length below 1e19).
// encoded: texel of a random texture, each channel in [0, 1], that stands for the direction 2 encoded - 1 of any
// length.
// Returns s reflected, of the same length; s itself where 2 encoded - 1 is zero (a grey texel) or not finite; the zero
// vector for a longer, infinite or NaN s. Error: 16 ulp of the largest component, while that is above 1e-30; shorter
// vectors may be flushed to 0.
// No method or pass here calls it: it is the reflection of the comparative study; the methods rotate.
vec3 gloam_reflect_sample(vec3 s, vec3 encoded) {
    if (!(dot(s, s) <= 1e38)) return vec3(0.0);
    vec3 n = gloam_safe_normalize(2.0 * encoded - 1.0, vec3(0.0));
    float squared = dot(n, n);
    if (!(squared > 0.5)) return s;
    // Division by n . n, which is 1 but for rounding, keeps the length of s.
    return s - (2.0 * dot(s, n) / squared) * n;
}

// Poisson-disc condition (POISSON): `|s_i - s_j| > d` [Aalund and Baerentzen 2013; Sourimant et al. 2011].
// candidate, other: points of the unit disc (coordinates below 1e18).
// min_distance: smallest allowed distance, in [0, 2]; a negative one is met by every pair of points.
// Returns whether the candidate may stand beside the other point; false if anything is NaN. Differences below 1e-19
// count as 0. Error: none, but for distances within rounding of min_distance.
// No method or pass here calls it: it is the condition of the comparative study; the methods take a finished pattern.
bool gloam_poisson_accepts(vec2 candidate, vec2 other, float min_distance) {
    vec2 offset = candidate - other;
    float squared = dot(offset, offset);
    return min_distance < 0.0 ? squared >= 0.0 : squared > min_distance * min_distance;
}

// disc point lifted onto the hemisphere (POISSON-lift): `(x, y, sqrt(1 - x^2 - y^2))` [Sourimant et al. 2011].
// disc: point of the unit disc; one outside is pulled to the rim.
// Returns a unit vector in tangent space (z along the normal). Uniform disc points become cosine-weighted directions,
// so an average over them carries no further cosine. The normal (0, 0, 1) for an infinite or NaN point.
// Error: 6e-6, where the point is within 1e-9 of the rim; 2e-7 elsewhere.
vec3 gloam_hemisphere_lift(vec2 disc) {
    vec3 rim = gloam_safe_normalize(vec3(disc, 0.0), vec3(0.0, 0.0, 1.0));
    if (!(dot(disc, disc) <= 1.5)) return rim;
    // 1 - x^2 - y^2 cancels near the rim. With a 12-bit head h of each coordinate, 1 - h.x^2 - h.y^2 is exact, and
    // x^2 = h.x^2 + (x - h.x) (x + h.x).
    vec2 head = floor(disc * 4096.0) * 0.000244140625;
    GLOAM_PRECISE float height_squared = ((1.0 - head.x * head.x) - head.y * head.y) - dot(disc - head, disc + head);
    return height_squared > 0.0 ? vec3(disc, gloam_sqrt(height_squared)) : vec3(rim.xy, 0.0);
}

#endif
