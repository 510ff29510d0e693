// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_POISSON_GLSL
#define GLOAM_SAMPLING_POISSON_GLSL

#include "gloam/geometry/safe_normalize.glsl"
#include "gloam/numeric/precise.glsl"
#include "gloam/numeric/square_root.glsl"

// Poisson-disc condition (POISSON): `|s_i - s_j| > d` [Aalund and Baerentzen 2013; Sourimant et al. 2011].
// candidate, other: points of the unit disc (coordinates below 1e18).
// min_distance: smallest allowed distance, in [0, 2]; a negative one is met by every pair of points.
// Returns whether the candidate may stand beside the other point; false if anything is NaN. Differences below 1e-19
// count as 0.
// Error: none, but for distances within rounding of min_distance.
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
