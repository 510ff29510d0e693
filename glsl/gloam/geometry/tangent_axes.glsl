// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_TANGENT_AXES_GLSL
#define GLOAM_GEOMETRY_TANGENT_AXES_GLSL

#include "gloam/numeric/constants.glsl"

// A slice (gloam/geometry/slice.glsl) in the axes of the tangent plane. An offset that is moved into the slice keeps
// its height over the tangent plane; so its place along that plane and its height are products of the offset itself
// with two vectors, and no offset is moved. Both products are affine in the depth of what a pixel sees.
struct GloamTangentAxes {
    vec3 along;    // its product with an offset: the place along the tangent plane, to the side of the direction
    vec3 height;   // likewise: the height over the tangent plane in the slice
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
