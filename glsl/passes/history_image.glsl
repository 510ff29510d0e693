// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_HISTORY_IMAGE_GLSL
#define GLOAM_PASSES_HISTORY_IMAGE_GLSL

// The image format of a history. Define GLOAM_HISTORY as rgba16f for four half floats, or GLOAM_PACKED_HISTORY for four
// fixed-point numbers of 16 bits (gloam/temporal/packed_history.glsl). The default is four floats.
//   layout(binding = B, GLOAM_HISTORY) uniform GLOAM_HISTORY_IMAGE image;
//   GLOAM_LOAD_HISTORY(image, pixel)          a GloamHistory
//   GLOAM_LOAD_HISTORY_TEXEL(image, pixel)    the same as a vec4, as gloam_history_pack gives it, but not sanitized
//   GLOAM_STORE_HISTORY(image, pixel, history)
// GLOAM_HISTORY_ROUNDS: true where a loaded value may differ from the stored one.

#include "gloam/temporal/history.glsl"
#include "gloam/temporal/packed_history.glsl"

#ifdef GLOAM_PACKED_HISTORY
#define GLOAM_HISTORY rgba16ui
#define GLOAM_HISTORY_IMAGE uimage2D
#define GLOAM_HISTORY_ROUNDS true

GloamPackedHistory packed_in(uvec4 texel) {
    return GloamPackedHistory(texel.x, texel.y, texel.z, texel.w);
}

GloamHistory history_from_texel(uvec4 texel) {
    return gloam_history_decode(packed_in(texel));
}

#define GLOAM_LOAD_HISTORY_TEXEL(image, pixel) gloam_packed_texel(packed_in(imageLoad(image, pixel)))

uvec4 texel_from_history(GloamHistory history) {
    GloamPackedHistory texel = gloam_history_encode(history);
    return uvec4(texel.occlusion, texel.weight, texel.index, texel.depth);
}
#else
#ifdef GLOAM_HISTORY
#define GLOAM_HISTORY_ROUNDS true
#else
#define GLOAM_HISTORY rgba32f
#define GLOAM_HISTORY_ROUNDS false
#endif
#define GLOAM_HISTORY_IMAGE image2D

GloamHistory history_from_texel(vec4 texel) {
    return gloam_history_unpack(texel);
}

#define GLOAM_LOAD_HISTORY_TEXEL(image, pixel) imageLoad(image, pixel)

vec4 texel_from_history(GloamHistory history) {
    return gloam_history_pack(history);
}
#endif

#define GLOAM_LOAD_HISTORY(image, pixel) history_from_texel(imageLoad(image, pixel))
#define GLOAM_STORE_HISTORY(image, pixel, history) imageStore(image, pixel, texel_from_history(history))

#endif
