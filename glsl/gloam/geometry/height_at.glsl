// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_HEIGHT_AT_GLSL
#define GLOAM_GEOMETRY_HEIGHT_AT_GLSL

// height of the surface of a tap at the aimed place (PAIR-height): `((s - p - a) . n) / (v . n)` [definition].
// How far along the view vector from an aimed place the surface lies that is as high over the tangent plane as what
// was seen.
// offset: s - p, from the shaded point to what was seen. aim: a, from there to the place, in the plane of the image;
// world units. normal: n, unit. facing: v . n, v the view vector, at least 1e-4.
// Returns a length in world units. Error: 1.5e-7 of the offset over v . n.
float gloam_height_at(vec3 offset, vec3 aim, vec3 normal, float facing) {
    return dot(offset - aim, normal) / facing;
}

#endif
