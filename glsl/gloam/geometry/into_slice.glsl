// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_INTO_SLICE_GLSL
#define GLOAM_GEOMETRY_INTO_SLICE_GLSL

#include "gloam/geometry/finite.glsl"

// offset moved into a slice along the tangent plane (SLICE-into): `v - (v . a) u, u . n = 0, u . a = 1` [definition].
// Moves an offset into the plane of a slice without changing its height over the tangent plane. What is seen at a
// pixel's centre lies beside the slice; dropping its part across the slice would lift the points of a tilted plane
// above that plane.
// offset: s - p, view space, world units. axis: unit, across the slice. normal: of the surface, unit.
// Returns offset - (offset . axis) u, where u lies in the tangent plane and u . axis = 1; the offset less its part
// along the axis where the slice is within 2 degrees of the tangent plane; the zero vector where it is not finite.
// Error: 3e-6 of |offset|, where (axis . normal)^2 < 0.9; 3e-4 of it beyond.
vec3 gloam_into_slice(vec3 offset, vec3 axis, vec3 normal) {
    float turned = dot(axis, normal);
    float steep = 1.0 - turned * turned;
    vec3 across = steep > 1e-3 ? (axis - turned * normal) / steep : axis;
    vec3 moved = offset - dot(offset, axis) * across;
    return gloam_is_finite3(moved) ? moved : vec3(0.0);
}

#endif
