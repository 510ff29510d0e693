// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_RADIUS_CAP_GLSL
#define GLOAM_GEOMETRY_RADIUS_CAP_GLSL

#include "gloam/geometry/projected_radius.glsl"
#include "gloam/numeric/length_ratio.glsl"

// projected radius held below a cap (CS-G-cap): `r min(1, cap / max(r_x, r_y))` [Gears of War 2 (Smedberg and Wright
// 2009)].
// Projected radius held below a cap, so that the taps of near pixels stay in the cache (Gears of War 2); both
// half-axes shrink alike, and with them the radius of influence in the world.
// axes: half-axes of the projected radius, pixels, >= 0 (negative and NaN count as 0). most: the cap, pixels, >= 0
// (the same).
// Returns the half-axes, the larger at most `most`. Error: 3.5 ULP for sizes up to 1e18.
vec2 gloam_radius_cap(vec2 axes, float most) {
    vec2 reach = vec2(gloam_positive_length(axes.x), gloam_positive_length(axes.y));
    float larger = max(reach.x, reach.y);
    float cap = gloam_positive_length(most);
    if (!(larger > cap)) return reach;
    // Not reach * (cap / larger): that quotient may be subnormal, and be flushed to 0.
    return cap * vec2(gloam_length_ratio(reach.x, larger), gloam_length_ratio(reach.y, larger));
}

#endif
