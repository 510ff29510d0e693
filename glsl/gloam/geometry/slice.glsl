// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_SLICE_GLSL
#define GLOAM_GEOMETRY_SLICE_GLSL

#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/square_root.glsl"
#include "gloam/numeric/unit_angle.glsl"

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
// What a half plane without anything in it amounts to, weighted by the cosine to the normal and by solid angle: cos n
// + n sin n.
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

#endif
