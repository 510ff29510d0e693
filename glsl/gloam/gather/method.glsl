// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_METHOD_GLSL
#define GLOAM_GATHER_METHOD_GLSL

// What a method of gloam/methods is made of: images, the kernel of a pixel and its estimate, taps, and the sequences
// that say where they lie.

#include "gloam/gather/fetch.glsl"
#include "gloam/gather/footprint.glsl"
#include "gloam/numeric/sincos.glsl"
#include "gloam/occlusion/blocked.glsl"
#include "gloam/sampling/count.glsl"
#include "gloam/sampling/disc.glsl"
#include "gloam/sampling/hemisphere.glsl"
#include "gloam/sampling/rotation.glsl"
#include "gloam/sampling/slice_sample.glsl"

#endif
