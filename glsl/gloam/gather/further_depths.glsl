// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_FURTHER_DEPTHS_GLSL
#define GLOAM_GATHER_FURTHER_DEPTHS_GLSL

// Defined by the user: depths of the layers behind the first, negative where seen from behind, 0 where there is none.
// Read with more than one layer, by hemisphere, ssdo and dual_resolution.
vec3 gloam_fetch_layers(ivec2 pixel);

// Depths of the layers behind the first, for a method that sees that many layers; with one nothing is read.
vec3 gloam_further_depths(ivec2 pixel, int layers) {
    return layers > 1 ? gloam_fetch_layers(pixel) : vec3(0.0);
}

#endif
