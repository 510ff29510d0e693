// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_SLICE_GLSL
#define GLOAM_GEOMETRY_SLICE_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/numeric/inverse_trigonometry.glsl"

// The plane through the eye and a direction of the image in which horizons are searched (Jimenez et al. 2016). Angles
// in it are measured from the view vector, positive towards the tangent.
struct GloamSlice {
    vec3 view;     // from the surface to the eye, unit
    vec3 tangent;  // in the slice, across the view vector, unit; the side of positive angles
    vec2 normal;   // direction of the normal's projection into the slice, (along view, along tangent), unit
    float angle;   // the same as an angle n, radians in [-pi / 2, pi / 2]
    float weight;  // length of that projection, [0, 1]
};

// slice through the eye, and the normal in it (GTAO-slice): `t = d - (d . v) v, normalised; n = atan((N . t) / (N .
// v)), weight |(N . t, N . v)|` [Jimenez et al. 2016].
// Slice of a direction of the image.
// direction: in the image plane, unit, y as in view space; 0 to pi of angles make all slices. view: unit, view space
// (orthographic: (0, 0, 1)).
// normal: of the surface, unit, view space; the part of one that faces away is left out, so that its angle is pi / 2
// one way or the other: whichever way rounding falls for one opposite to the view vector.
// Returns the slice; weight 0, for which it counts nothing, where the normal is perpendicular to it, and for a
// direction along the view vector. NaN for NaN. Error: 6e-7 for directions and normals well away from those; of the
// angle and of the normal 2e-7 / weight.
GloamSlice gloam_slice(vec2 direction, vec3 view, vec3 normal) {
    vec3 along = vec3(direction, 0.0) - dot(direction, view.xy) * view;
    float across = dot(along, along);
    vec3 tangent = across >= GLOAM_LEAST_SQUARE ? along * inversesqrt(across) : vec3(0.0);
    vec2 part = vec2(dot(normal, view), dot(normal, tangent));
    float weight = gloam_sqrt(dot(part, part));
    if (!(weight > 0.0 && across >= GLOAM_LEAST_SQUARE))
        return GloamSlice(vec3(0.0, 0.0, 1.0), tangent, vec2(1.0, 0.0), 0.0, 0.0);
    part = part.x > 0.0 ? part * inversesqrt(dot(part, part)) : vec2(0.0, part.y < 0.0 ? -1.0 : 1.0);
    float angle = gloam_unit_angle(vec2(part.x, abs(part.y)));
    return GloamSlice(view, tangent, part, part.y < 0.0 ? -angle : angle, min(weight, 1.0));
}

// amount of an empty half plane (GTAO-slice-whole): `cos n + n sin n` [Jimenez et al. 2016].
// Weighted by the cosine to the normal and by solid angle.
// Returns an amount in [1, pi / 2]. Error: 3e-7.
float gloam_slice_whole(GloamSlice slice) {
    return slice.normal.x + slice.angle * slice.normal.y;
}

// What takes offsets into the plane of a slice without changing their height over the tangent plane. What is seen at
// a pixel's centre lies beside the slice; dropping its part across the slice would lift the points of a tilted plane
// above that plane.
struct GloamSliceAxes {
    vec3 view;     // its product with an offset is that of the moved offset with the slice's view vector
    vec3 tangent;  // likewise with the tangent
};

// vectors that take offsets into a slice along the tangent plane (SLICE-axes): `(v - (u . v) a, t - (u . t) a), u . n =
// 0, u . a = 1` [definition].
// normal: of the surface, unit. As gloam_into_slice, whose result has (dot(offset, axes.view), dot(offset,
// axes.tangent)) within the slice.
// Returns the slice's own vectors where it is within 2 degrees of the tangent plane: parts across it are dropped
// there. Error: 3e-6 where (axis . normal)^2 < 0.9; 3e-4 beyond.
GloamSliceAxes gloam_slice_axes(GloamSlice slice, vec3 normal) {
    vec3 axis = cross(slice.tangent, slice.view);
    vec2 part = vec2(dot(normal, slice.view), dot(normal, slice.tangent));
    float squared = dot(part, part);  // 1 - (axis . normal)^2
    vec2 moved = squared > 1e-3 ? part * (dot(axis, normal) / squared) : vec2(0.0);
    return GloamSliceAxes(slice.view + moved.x * axis, slice.tangent + moved.y * axis);
}

// offset moved into a slice along the tangent plane (SLICE-into): `v - (v . a) u, u . n = 0, u . a = 1` [definition].
// Its height over the tangent plane stays (GloamSliceAxes).
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

// A slice (gloam/geometry/slice.glsl) in the axes of the tangent plane. An offset that is moved into the slice keeps
// its height over the tangent plane; so its place along that plane and its height are products of the offset itself
// with two vectors, and no offset is moved. Both products are affine in the depth of what a pixel sees.
struct GloamTangentAxes {
    vec3 along;    // its product with an offset: the place along the tangent plane, to the side of the direction
    vec3 height;   // its product with an offset: the height over the tangent plane, in the slice
    vec2 normal;   // (cos n, sin n), n the angle of the normal in the slice from the view vector
    float weight;  // length of the normal's projection into the slice, [0, 1]
};

// slice in the axes of the tangent plane (FRAME-axes): `along cos n t - sin n v, height N / |N_p|; t = d - (d . v) v,
// normalised; N_p = ((N . v), (N . t)) = |N_p| (cos n, sin n)` [gloam; the slice of Jimenez et al. 2016].
// direction: in the image plane, unit, the way y of view space goes in the image. view: unit, from the surface to the
// eye, not along the direction. normal: of the surface, unit. Where it faces away from the eye, n is pi / 2 one way or
// the other, as in gloam_slice, and the height is of no use.
// Trusts its caller: nothing is tested. Weight 0 and (0, 0) for n where the normal is across the slice.
// Error: 3e-6 where |N_p|^2 > 0.1 and the view is 0.3 or more off the image plane.
GloamTangentAxes gloam_tangent_axes(vec2 direction, vec3 view, vec3 normal) {
    float across = dot(direction, view.xy);
    float scale = inversesqrt(1.0 - across * across);
    float facing = dot(normal, view);
    vec2 part = vec2(max(facing, 0.0), scale * (dot(normal.xy, direction) - across * facing));
    float squared = dot(part, part);
    float inverse = inversesqrt(max(squared, GLOAM_LEAST_SQUARE));
    vec2 plane = inverse * part;
    float to_direction = plane.x * scale;
    float to_view = to_direction * across + plane.y;
    return GloamTangentAxes(vec3(to_direction * direction - to_view * view.xy, -to_view * view.z), inverse * normal,
                            plane, squared * inverse);
}

// amount of an empty slice, by a short arc cosine (FRAME-whole): `cos n + |sin n| acos(cos n)` [Jimenez et al.
// 2016; the arc cosine of Lagarde 2014].
// As gloam_slice_whole. acos(c) is taken as (1.5708 - 0.1566 c) sqrt(1 - c).
// plane: (cos n, sin n), cos n >= 0. Returns an amount in [1, pi / 2]; 0.57 for (0, 0). Error: 0.009.
float gloam_tangent_whole(vec2 plane) {
    return (1.5707963 - 0.156583 * plane.x) * sqrt(abs(1.0 - plane.x)) * abs(plane.y) + plane.x;
}

// both taps of a step (FRAME-pair): `q d - s d0 in perspective, q + s (d - d0) orthographic; along the plane, mirrored
// for the other side` [gloam].
// A pixel with the ray t sees d (t, -1) in perspective. The product of an axis with it, less that of the own point
// d0 (r, -1), is q d - s d0, where q = axis . (t, -1) and s = axis . (r, -1) = -|(r, -1)| (axis . v). s is
// |(r, -1)| sin n along the tangent plane and -|(r, -1)| cos n over it. An orthographic camera sees (t, -d), and
// q = axis . (t - r, 0). So q is affine in the place of the tap in the image.
// along, height: q of both sides. slope: |(r, -1)| (cos n, sin n). own: d0. depth: d of both sides, all in the unit in
// which the result is.
// Returns what both taps see, each from its own side: places along the tangent plane, outwards, in xy, and heights
// over it in zw. Error: 4e-7 of the sum of the terms.
vec4 gloam_tap_pair(vec2 along, vec2 height, vec2 slope, float own, vec2 depth, bool orthographic) {
    vec2 farther = depth - own;
    vec2 sides = orthographic ? along + slope.y * farther : along * depth - slope.y * own;
    return vec4(sides.x, -sides.y, orthographic ? height - slope.x * farther : height * depth + slope.x * own);
}

#endif
