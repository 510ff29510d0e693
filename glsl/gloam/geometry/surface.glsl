// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_SURFACE_GLSL
#define GLOAM_GEOMETRY_SURFACE_GLSL

#include "gloam/geometry/vector.glsl"
#include "gloam/numeric/arithmetic.glsl"

// direction of the surface along one image axis (NORMAL-direction): `one-sided difference of smaller |dz|, normalised`
// [definition; one-sided differences as in Bavoil and Sainz 2009].
// It does not reach across a silhouette. The difference to the neighbour ahead where both change alike.
// center, behind, ahead: view-space positions in world units; a neighbour that is not in front of the eye (z not
// negative: the zero vector of a background pixel) is not used.
// Returns a unit vector; the zero vector without a usable neighbour, or with one at the centre itself. Error: at most
// 6 ulp.
vec3 gloam_neighbor_direction(vec3 center, vec3 behind, vec3 ahead) {
    bool has_behind = !gloam_is_background(-behind.z);
    bool has_ahead = !gloam_is_background(-ahead.z);
    if (!has_behind && !has_ahead) return vec3(0.0);
    bool ahead_closer = abs(ahead.z - center.z) <= abs(center.z - behind.z);
    bool use_ahead = has_ahead && (!has_behind || ahead_closer);
    return gloam_safe_normalize(use_ahead ? ahead - center : center - behind, vec3(0.0));
}

// normal of two directions, turned towards the viewer (NORMAL-facing): `x cross y, normalised; the sign that faces the
// viewer` [definition].
// along_x, along_y: unit vectors in the surface, or zero. toward_viewer: direction of the viewer, of any length.
// Returns a unit vector; (0, 0, 1), straight at the viewer, where the directions are zero, within 1e-5 radians of
// parallel, infinite or NaN, and where their cross product is longer than 2.
// Error: about 1e-7 over the sine of the angle between the directions.
vec3 gloam_facing_normal(vec3 along_x, vec3 along_y, vec3 toward_viewer) {
    vec3 normal = cross(along_x, along_y);
    float squared = dot(normal, normal);
    if (!(squared >= 1e-10 && squared <= 4.0)) return vec3(0.0, 0.0, 1.0);
    normal *= inversesqrt(squared);
    return dot(normal, toward_viewer) < 0.0 ? -normal : normal;
}

// normal from a position and its four neighbours (NORMAL): `cross product of the one-sided differences of smaller |dz|;
// n . center <= 0` [definition; one-sided differences as in Bavoil and Sainz 2009].
// center, left, right, up, down: view-space positions in world units, the zero vector (or any z that is not negative)
// where a neighbour is background or outside the image.
// Returns a unit vector n with n . center <= 0; (0, 0, 1) where too few neighbours are usable or the differences are
// parallel; the zero vector where the centre is background. Error: 5e-7 for differences at 0.02 radians or more to
// each other and coordinates of 1e-30 to 1e6.
vec3 gloam_normal_from_neighbors(vec3 center, vec3 left, vec3 right, vec3 up, vec3 down) {
    if (gloam_is_background(-center.z)) return vec3(0.0);
    return gloam_facing_normal(gloam_neighbor_direction(center, left, right),
                               gloam_neighbor_direction(center, down, up), -center);
}

// normal from a position and its four neighbours (NORMAL-orthographic): `cross product of the one-sided differences of
// smaller |dz|; n.z >= 0` [definition; one-sided differences as in Bavoil and Sainz 2009].
// For an orthographic view, in which every surface is seen along -z.
// center, left, right, up, down and what it returns: as for gloam_normal_from_neighbors, but n.z >= 0. Error: 4e-6 for
// differences at 0.02 radians or more to each other and coordinates of 1e-30 to 1e6.
vec3 gloam_normal_from_neighbors_orthographic(vec3 center, vec3 left, vec3 right, vec3 up, vec3 down) {
    if (gloam_is_background(-center.z)) return vec3(0.0);
    return gloam_facing_normal(gloam_neighbor_direction(center, left, right),
                               gloam_neighbor_direction(center, down, up), vec3(0.0, 0.0, 1.0));
}

// principal curvatures from neighbouring pixels (CS-K-principal): `eigenvalues of the shape operator, -dn = S dp`
// [differential geometry].
// The operator is formed in an orthonormal frame of the tangent plane, where nothing cancels for a ball.
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

// Mean and variance of the surface points of several pixels, for methods that take one sample of an area: of a plane
// they say exactly where it is and that nothing stands out of it.
struct GloamSurfaceMoments {
    float weight;     // pixels with a surface; 0: nothing else is meant
    vec3 mean;        // of their positions, world units
    vec3 variance;    // of x, y, z, world units squared
    vec3 covariance;  // of (y, z), (z, x), (x, y), world units squared
};

// moments of no surface point (MOMENTS-empty): `weight 0` [definition].
// Of no pixel. Returns a weight of 0 and zeros. Error: none.
GloamSurfaceMoments gloam_moments_empty() {
    return GloamSurfaceMoments(0.0, vec3(0.0), vec3(0.0), vec3(0.0));
}

// moments of one surface point (MOMENTS-of): `weight 1, its mean, no variance` [definition].
// Of one pixel. point: its surface, any space, world units, finite. Returns its moments. Error: none.
GloamSurfaceMoments gloam_moments_of(vec3 point) {
    return GloamSurfaceMoments(1.0, point, vec3(0.0), vec3(0.0));
}

// moments of two groups of surface points (MOMENTS-add): `m = m_a + t d;  C = (1 - t) C_a + t C_b + t (1 - t) d d^T,  d
// = m_b - m_a,  t = w_b / w` [Chan, Golub and LeVeque 1979].
// Sums of squares would lose the variance in the digits of the distance from the eye.
// a, b: finite; weights of at least 2^-10, or 0: then the rest is not read.
// Returns the moments of both; those of the other for a weight of 0. Error: 4 ULP of the weight, 3e-7 of the
// larger mean, 1e-6 of the larger of the variances and the squared distance of the means.
GloamSurfaceMoments gloam_moments_add(GloamSurfaceMoments a, GloamSurfaceMoments b) {
    if (!(b.weight > 0.0)) return a;
    if (!(a.weight > 0.0)) return b;
    float weight = a.weight + b.weight;
    float part = b.weight / weight;
    float spread = part * (a.weight / weight);
    vec3 apart = b.mean - a.mean;
    vec3 mean = a.mean + part * apart;
    vec3 variance = a.variance + part * (b.variance - a.variance) + spread * (apart * apart);
    vec3 covariance = a.covariance + part * (b.covariance - a.covariance) + spread * (apart.yzx * apart.zxy);
    return GloamSurfaceMoments(weight, mean, variance, covariance);
}

// variance of surface points along a direction (MOMENTS-along): `max(n^T C n, 0)` [definition].
// moments: finite. direction: n, unit, the same space.
// Returns a variance in world units squared, >= 0: what rounding takes below is 0, and so is NaN. Error: 1e-6 of the
// largest of the variances.
float gloam_moments_along(GloamSurfaceMoments moments, vec3 direction) {
    float along = dot(moments.variance, direction * direction) +
                  2.0 * dot(moments.covariance, direction.yzx * direction.zxy);
    return along > 0.0 ? along : 0.0;
}

#endif
