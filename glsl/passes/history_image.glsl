// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_HISTORY_IMAGE_GLSL
#define GLOAM_PASSES_HISTORY_IMAGE_GLSL

// The image format of a history: four floats, or, with GLOAM_PACKED_HISTORY, four fixed-point numbers of 16 bits
// (gloam/temporal/packed_history.glsl). A pass reads one history and writes another, so none is both read and written.
//   layout(binding = B GLOAM_FORMAT(GLOAM_HISTORY)) uniform GLOAM_HISTORY_INPUT image;
//   layout(binding = B, GLOAM_HISTORY) uniform writeonly GLOAM_HISTORY_IMAGE image;
//   GLOAM_LOAD_HISTORY(image, pixel)          a GloamHistory
//   GLOAM_LOAD_HISTORY_TEXEL(image, pixel)    the same as a vec4, as gloam_history_pack gives it, but not sanitized
//   GLOAM_STORE_HISTORY(image, pixel, history)
// GLOAM_HISTORY_ROUNDS: true where what a load gives after a store may differ from the history, sanitized.

#include "gloam/temporal/history.glsl"
#include "gloam/temporal/packed_history.glsl"
#include "passes/input_image.glsl"

#ifdef GLOAM_PACKED_HISTORY
#define GLOAM_HISTORY rgba16ui
#define GLOAM_HISTORY_IMAGE highp uimage2D
#define GLOAM_HISTORY_INPUT GLOAM_UINT_INPUT
#define GLOAM_HISTORY_ROUNDS true

GloamPackedHistory packed_in(uvec4 texel) {
    return GloamPackedHistory(texel.x, texel.y, texel.z, texel.w);
}

GloamHistory history_from_texel(uvec4 texel) {
    return gloam_history_decode(packed_in(texel));
}

#define GLOAM_LOAD_HISTORY_TEXEL(image, pixel) gloam_packed_texel(packed_in(GLOAM_FETCH(image, pixel)))

uvec4 texel_from_history(GloamHistory history) {
    GloamPackedHistory texel = gloam_history_encode(history);
    return uvec4(texel.occlusion, texel.weight, texel.index, texel.depth);
}
#else
#define GLOAM_HISTORY rgba32f
#define GLOAM_HISTORY_IMAGE highp image2D
#define GLOAM_HISTORY_INPUT GLOAM_INPUT
#define GLOAM_HISTORY_ROUNDS false

vec4 texel_from_history(GloamHistory history) {
    return gloam_history_pack(history);
}

GloamHistory history_from_texel(vec4 texel) {
    return gloam_history_unpack(texel);
}

#define GLOAM_LOAD_HISTORY_TEXEL(image, pixel) GLOAM_FETCH(image, pixel)
#endif

#define GLOAM_LOAD_HISTORY(image, pixel) history_from_texel(GLOAM_FETCH(image, pixel))
#define GLOAM_STORE_HISTORY(image, pixel, history) imageStore(image, pixel, texel_from_history(history))

#endif
