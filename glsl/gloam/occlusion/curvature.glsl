// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_CURVATURE_GLSL
#define GLOAM_OCCLUSION_CURVATURE_GLSL

#include "gloam/numeric/inverse_trigonometry.glsl"
#include "gloam/sampling/unit_interval.glsl"

// Ambient occlusion by the curvature of the surface (after Hattori et al. 2012). The surface around the point is
// replaced by its quadric, cut at a radius: z(t, phi) = k(phi) t^2 / 2, k(phi) = k_1 cos^2 phi + k_2 sin^2 phi.
// Concave curvature is positive. Seen from the point, the edge of the quadric has the horizon angle h, where
// tan h = q(phi) = max(k(phi), 0) R / 2. The occlusion is the mean of sin^2 h = q^2 / (1 + q^2) over phi. Both
// functions below are that mean in closed form, from the integral of 1 / (1 + i q).

// occlusion in a bowl (CS-K-bowl): `1 - Re 1 / sqrt((1 + i a) (1 + i b))` [derived, after Hattori et al. 2012].
// In a furrow, too.
// a, b: k_1 R / 2 and k_2 R / 2, both in [0, 4096]. (b down to -1e-4 changes the result by less than 1e-8.)
// Returns occlusion in [0, 1]; a^2 / (1 + a^2) for a = b. Error: 4e-7.
float gloam_occlusion_bowl(float a, float b) {
    float product = a * b;
    float size = gloam_sqrt((1.0 + a * a) * (1.0 + b * b));
    float sum = a + b;
    // Half of size + 1 - a b, which cancels in a deep bowl.
    float part = product > 1.0 ? 0.5 * sum * (sum / (size + (product - 1.0))) : 0.5 * (size + (1.0 - product));
    return gloam_unit_interval(1.0 - gloam_sqrt(part) / size);
}

// occlusion on a saddle (CS-K-saddle): `(2 / pi) (phi_0 - Re atan(t sqrt(B / A)) / sqrt(A B)), t = tan phi_0 = sqrt(-a
// / b)` [derived, after Hattori et al. 2012].
// That of the directions in which it rises; A = 1 + i a, B = 1 + i b.
// a: k_1 R / 2 in (0, 4096]. b: k_2 R / 2 in [-4096, -1e-4].
// Returns occlusion in [0, 1]. Error: 8e-7.
float gloam_occlusion_saddle(float a, float b) {
    float t = gloam_sqrt(a / -b);
    float size = gloam_sqrt((1.0 + a * a) * (1.0 + b * b));
    vec2 root = vec2(gloam_sqrt(0.5 * (size + (1.0 - a * b))), 0.0);  // sqrt(A B)
    root.y = 0.5 * (a + b) / root.x;
    vec2 w = t / (1.0 + a * a) * vec2(root.x + a * root.y, root.y - a * root.x);
    vec2 arc = vec2(0.5 * gloam_atan2(2.0 * w.x, 1.0 - dot(w, w)),
                    0.25 * log((w.x * w.x + (1.0 + w.y) * (1.0 + w.y)) / (w.x * w.x + (1.0 - w.y) * (1.0 - w.y))));
    return gloam_unit_interval(0.636619772 * (gloam_atan(t) - dot(arc, root) / size));
}

// occlusion by principal curvatures (CS-K): `mean over phi of q^2 / (1 + q^2), q = max(k_1 cos^2 phi + k_2 sin^2 phi,
// 0) R / 2` [derived, after Hattori et al. 2012].
// k_1, k_2: principal curvatures, 1 / world units, in any order, positive where the surface is concave. radius: R,
// where the surface around the point ends, world units, > 0.
// Returns occlusion in [0, 1]: 0 where neither is positive (plane, ridge, ball), 1/2 for k_1 = k_2 = 2 / R. k R / 2
// is taken into [-4096, 4096]. 0 for a radius not positive and for NaN. Error: 8e-7.
float gloam_occlusion_curvature(float k_1, float k_2, float radius) {
    float larger = 0.5 * radius * (k_1 > k_2 ? k_1 : k_2);
    float smaller = 0.5 * radius * (k_1 > k_2 ? k_2 : k_1);
    if (!(radius > 0.0 && larger > 0.0 && (smaller >= 0.0 || smaller < 0.0))) return 0.0;
    float a = min(larger, 4096.0);
    float b = clamp(smaller, -4096.0, 4096.0);
    return b >= -1e-4 ? gloam_occlusion_bowl(a, b) : gloam_occlusion_saddle(a, b);
}

#endif
