// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_SLICE_GLSL
#define GLOAM_GEOMETRY_SLICE_GLSL

#include "gloam/geometry/safe_normalize.glsl"
#include "gloam/numeric/inverse_trigonometry.glsl"

// The plane through the eye and a direction of the image in which horizons are searched (Jimenez et al. 2016). Angles in it are measured
// from the view vector, positive towards the tangent.
struct GloamSlice {
    vec3 view;     // from the surface to the eye, unit
    vec3 tangent;  // in the slice, across the view vector, unit; the side of positive angles
    float angle;   // of the normal's projection into the slice, radians
    float weight;  // length of that projection, [0, 1]
};

// Slice of a direction of the image.
// direction: in the image plane, unit, y as in view space; 0 to pi of angles make all slices. view: unit, view space (orthographic: (0, 0, 1)).
// normal: of the surface, unit, view space.
// Returns the slice; weight 0, for which it counts nothing, where the normal is perpendicular to it, for a direction along the view
// vector, and for NaN. Error: 6e-7 for directions and normals well away from those; of the angle
// 2e-7 / weight.
GloamSlice gloam_slice(vec2 direction, vec3 view, vec3 normal) {
    vec3 along = vec3(direction, 0.0);
    vec3 tangent = gloam_safe_normalize(along - dot(along, view) * view, vec3(0.0));
    float x = dot(normal, tangent);
    float y = dot(normal, view);
    float weight = gloam_sqrt(x * x + y * y);
    if (!(weight > 0.0 && dot(tangent, tangent) > 0.5)) return GloamSlice(vec3(0.0, 0.0, 1.0), tangent, 0.0, 0.0);
    return GloamSlice(view, tangent, clamp(gloam_atan2(x, y), -1.570796327, 1.570796327), min(weight, 1.0));
}

// Angle of a sample in the slice.
// offset: s - p, view space, world units; its part across the slice is dropped.
// Returns radians in [-pi, pi] from the view vector; 0 for a zero offset and for NaN. Error: 6e-7 where |offset| lies mostly in the slice.
float gloam_slice_angle(vec3 offset, GloamSlice slice) {
    vec3 direction = gloam_safe_normalize(offset, vec3(0.0));
    return gloam_atan2(dot(direction, slice.tangent), dot(direction, slice.view));
}

#endif
