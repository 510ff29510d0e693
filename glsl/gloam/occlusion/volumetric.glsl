// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_VOLUMETRIC_GLSL
#define GLOAM_OCCLUSION_VOLUMETRIC_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/numeric/arithmetic.glsl"

// Volumetric obscurance by line samples (Loos and Sloan 2010; CS-3.5): the solid part of a sphere around the point.
// Each tap of a disc is a chord of the sphere along the view ray; the depth buffer determines the solid part of the
// chord. A plane gives 1/2 at any tilt (the offset 0.5 of gloam_remap compensates this), a one-sided groove of angle b
// gives 1/2 + b / (2 pi).
// The volume is the mean of the parts weighted by chord, calculated by gloam_weighted_mean_add. The published shader
// uses the plain mean, which is too large in grooves (0.647 instead of 0.625 at 45 degrees), and starts it with (0.5,
// 1), a prior for few samples.

// half the chord of the sphere at a tap (CS-I-chord): `h = r (1 - |xi|^2)^(1/2)` [Loos and Sloan 2010; Aalund and
// Baerentzen 2013, eq 3.5].
// xi: offset of the tap from the centre in the unit disc (the published shader takes the absolute texture coordinate,
// which is no offset).
// radius: r, world units, >= 0.
// Returns a length in [0, r]; 0 for |xi| >= 1, r not positive, and NaN. Error: 3e-7 of r / sqrt(1 - |xi|^2).
float gloam_chord_half_height(vec2 xi, float radius) {
    float height = radius * gloam_sqrt(1.0 - dot(xi, xi));
    return height > 0.0 ? height : 0.0;
}

// solid part of a chord (CS-I): `q = clamp((h + z_s - z_p) / (2 h), 0, 1)` [Loos and Sloan 2010; Aalund and Baerentzen
// 2013, eq 3.5].
// This is the occluded part; the source's text calls it unoccluded.
// height: z = z_s - z_p, view space, world units: of the surface at the tap above the centre, positive if nearer to
// the eye; -infinity for background. half_height: h, world units.
// Returns occlusion in [0, 1]; 1/2 for h that is not positive, subnormal or above 2^126, and for NaN. Error: 1.2e-7.
float gloam_line_occlusion(float height, float half_height) {
    if (!(half_height >= GLOAM_SMALLEST && half_height <= GLOAM_LARGEST_DIVISOR)) return 0.5;
    if (height >= half_height) return 1.0;
    if (height <= -half_height) return 0.0;
    return abs(height) < half_height ? 0.5 + 0.5 * (height / half_height) : 0.5;
}

// where the surface at a tap lies along the chord (CS-I-ratio): `q* = (h + z_s - z_p) / (2 h)` [Loos and Sloan 2010;
// Aalund and Baerentzen 2013, eq 3.5].
// 0 at the far end, 1 at the near end, not clamped. gloam_line_pair uses it to detect other objects: a surface in front
// of the sphere has q* > 1, where the clamped fraction would be solid.
// height, half_height: as above.
// Returns any float; -infinity for background, 1/2 for h that is not positive, subnormal or above 2^126, and for NaN.
// Error: 2e-7, or 3 ULP, up to 1e38.
float gloam_line_ratio(float height, float half_height) {
    if (!(half_height >= GLOAM_SMALLEST && half_height <= GLOAM_LARGEST_DIVISOR)) return 0.5;
    float ratio = 0.5 + 0.5 * (height / half_height);
    return gloam_is_nan(ratio) ? 0.5 : ratio;
}

// pair of opposite taps, a disbelieved one replaced (CS-I-pair): `q_i where lowest <= q_i <= highest, else 1 - q_j,
// else 1/2` [Loos and Sloan 2010; Aalund and Baerentzen 2013, eq 3.5].
// A surface in front of the sphere, or far behind the point, belongs to another object; then 1 - the partner's fraction
// replaces its own.
// ratios: (q*_1, q*_2) of gloam_line_ratio, not clamped. lowest, highest: range of valid fractions, 0.35 and 1 in the
// published shader.
// Returns the two fractions, an invalid one replaced by 1 - the other; (0.5, 0.5) if both are invalid. NaN is invalid.
// Error: 0.5 ULP.
vec2 gloam_line_pair(vec2 ratios, float lowest, float highest) {
    bool first = ratios.x >= lowest && ratios.x <= highest;
    bool second = ratios.y >= lowest && ratios.y <= highest;
    if (first && second) return ratios;
    if (first) return vec2(ratios.x, 1.0 - ratios.x);
    return second ? vec2(1.0 - ratios.y, ratios.y) : vec2(0.5);
}

// solid part of a chord over an area of heights (CS-I-area): `(1 / (2 w)) integral of clamp((h + z) / (2 h), 0, 1) dz
// over [m - w, m + w]` [Loos and Sloan 2010, reconstructed].
// Over the area, the surface is at any height of an interval alike. An interval of the distribution's variance has w =
// sqrt(3 variance).
// height: m, mean of the heights as for gloam_line_occlusion. half_width: w, world units, >= 0. half_height: h.
// Returns occlusion in [0, 1]; that of the mean height for w = 0, negative or NaN; 1/2 for h that is not positive,
// subnormal or above 2^126, for w above 2^126, and for a NaN height. Error: 2e-7.
float gloam_area_occlusion(float height, float half_width, float half_height) {
    if (!(half_width > 0.0)) return gloam_line_occlusion(height, half_height);
    if (!(half_height >= GLOAM_SMALLEST && max(half_height, half_width) <= GLOAM_LARGEST_DIVISOR)) return 0.5;
    float beyond_far = half_height + height - half_width;  // of the lower end, from the chord's far end
    float beyond_near = half_height - height - half_width;  // of the upper end, back from its near end
    if (beyond_far >= 0.0 && beyond_near >= 0.0) return 0.5 + 0.5 * (height / half_height);
    float far = half_height + height + half_width;
    float near = half_height - height + half_width;
    if (!(near > 0.0)) return near <= 0.0 ? 1.0 : 0.5;
    if (!(far > 0.0)) return 0.0;
    if (beyond_far < 0.0 && beyond_near < 0.0) return clamp(0.5 + 0.5 * (height / half_width), 0.0, 1.0);
    bool crosses_near = beyond_near < 0.0;
    float length_inside = crosses_near ? near : far;
    float share = 0.125 * (length_inside / half_height) * (length_inside / half_width);
    return clamp(crosses_near ? 1.0 - share : share, 0.0, 1.0);
}

// balls of two radii as one occlusion (CS-I-two-balls): `clamp(q_fine + q_broad - 1/2, 0, 1)` [after Loos and Sloan
// 2010].
// fine, broad: solid share of each, [0, 1].
// Returns clamp(fine + broad - 1/2, 0, 1); what is not finite counts as 1/2. Error: 1.2e-7.
float gloam_two_balls(float fine, float broad) {
    float sum = (abs(fine) <= GLOAM_LARGEST ? fine - 0.5 : 0.0) + (abs(broad) <= GLOAM_LARGEST ? broad : 0.5);
    return clamp(sum, 0.0, 1.0);
}

// half the chord of the tangent sphere (CS-I-tangent-chord): `(r / 2) (1 - |2 v.xy / r - n.xy|^2)^(1/2)` [Szirmay-Kalos
// et al. 2009].
// The sphere of half the radius touches the surface from outside: a plane leaves it empty, and no offset is needed.
// offset: s - p, view space, world units, of which x and y count. normal: n, unit. radius: r of the whole kernel,
// world units; the sphere's centre is p + n r / 2.
// Returns a length in [0, r / 2], the weight of the tap; 0 beside the sphere, for r not positive, and for NaN. Error:
// 4e-7 of r / 2, more towards the sphere's outline.
float gloam_tangent_sphere_half_height(vec3 offset, vec3 normal, float radius) {
    if (!(radius >= GLOAM_SMALLEST && radius <= GLOAM_LARGEST_DIVISOR)) return 0.0;
    float half_radius = 0.5 * radius;
    vec2 xi = offset.xy / half_radius - normal.xy;
    float height = half_radius * gloam_sqrt(1.0 - dot(xi, xi));
    return height > 0.0 ? height : 0.0;
}

// solid part of a chord of the tangent sphere (CS-I-tangent): `q of the sphere of radius r / 2 around p + n r / 2`
// [Szirmay-Kalos et al. 2009].
// offset, normal, radius: as above.
// Returns occlusion in [0, 1]; 0 where there is no chord and for NaN. Error: 5e-7, more towards the sphere's outline.
float gloam_tangent_sphere_occlusion(vec3 offset, vec3 normal, float radius) {
    float half_height = gloam_tangent_sphere_half_height(offset, normal, radius);
    float height = offset.z - 0.5 * radius * normal.z;
    bool known = half_height >= GLOAM_SMALLEST && !gloam_is_nan(height);
    return known ? gloam_line_occlusion(height, half_height) : 0.0;
}

#endif
