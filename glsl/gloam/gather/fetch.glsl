// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_FETCH_GLSL
#define GLOAM_GATHER_FETCH_GLSL

// What methods and filters read of the images. Only those functions have to be defined that are called.

// Defined by the user: eye-linear depth of a pixel inside the image, world units.
float gloam_fetch_depth(ivec2 pixel);

// Defined by the user: view-space normal of a pixel inside the image, facing the eye: of any length for methods, unit
// for filters; the zero vector where there is none.
vec3 gloam_fetch_normal(ivec2 pixel);

// Defined by the user: texel of the image that the preparation passes of a method have written; the method's comment
// says what it holds.
vec4 gloam_fetch_prepared(ivec2 texel);

// Defined by the user: occlusion (or visibility) of a pixel inside the image, in [0, 1].
float gloam_fetch_occlusion(ivec2 pixel);

#endif
