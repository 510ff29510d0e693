// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_FURTHER_DEPTHS_GLSL
#define GLOAM_GATHER_FURTHER_DEPTHS_GLSL

#include "gloam/gather/fetch.glsl"

// Depths of the layers behind the first (gloam_fetch_layers), for a kernel of that many layers; with one nothing is
// read.
vec3 gloam_further_depths(ivec2 pixel, int layers) {
    return layers > 1 ? gloam_fetch_layers(pixel) : vec3(0.0);
}

#endif
