// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_NORMAL_GLSL
#define GLOAM_GEOMETRY_NORMAL_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/geometry/safe_normalize.glsl"

// direction of the surface along one image axis (NORMAL-direction): `one-sided difference of smaller |dz|, normalised`
// [definition; one-sided differences as in Bavoil and Sainz 2009].
// Direction from a position to its neighbours along one image axis: the one-sided difference with the smaller change
// of depth, which does not reach across a silhouette. The difference to the neighbour ahead where both change alike.
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
// The same for an orthographic view, in which every surface is seen along -z: the normal is turned to n.z >= 0.
// center, left, right, up, down: as for gloam_normal_from_neighbors.
// Returns a unit vector n with n.z >= 0; (0, 0, 1) where too few neighbours are usable or the differences are
// parallel; the zero vector where the centre is background. Error: 4e-6 for differences at 0.02 radians or more to
// each other and coordinates of 1e-30 to 1e6.
vec3 gloam_normal_from_neighbors_orthographic(vec3 center, vec3 left, vec3 right, vec3 up, vec3 down) {
    if (gloam_is_background(-center.z)) return vec3(0.0);
    return gloam_facing_normal(gloam_neighbor_direction(center, left, right),
                               gloam_neighbor_direction(center, down, up), vec3(0.0, 0.0, 1.0));
}

#endif
