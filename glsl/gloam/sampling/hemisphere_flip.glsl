// SPDX-License-Identifier: MIT
#ifndef GLOAM_SAMPLING_HEMISPHERE_FLIP_GLSL
#define GLOAM_SAMPLING_HEMISPHERE_FLIP_GLSL

// sample brought into the hemisphere of a normal (FLIP): `s if s . n > 0, else -s` [Filion and McNaughton 2008].
// What is uniform on the sphere stays uniform on the hemisphere.
// s: sample point, in the space of the normal, in units of the kernel radius (length below 1e19).
// normal: direction, of any length below 1e19.
// Returns s or -s; -s where s . n = 0, as faceforward(s, s, -n) does, and where the normal is NaN; the zero vector
// for a longer, infinite or NaN s. Error: none, but for the sign of an s within rounding of the tangent plane.
// No method or pass here calls it: it is the flip of the comparative study; the methods draw half balls.
vec3 gloam_hemisphere_flip(vec3 s, vec3 normal) {
    if (!(dot(s, s) <= 1e38)) return vec3(0.0);
    return dot(s, normal) > 0.0 ? s : -s;
}

#endif
