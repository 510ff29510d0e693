// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_INPUT_IMAGE_GLSL
#define GLOAM_PASSES_INPUT_IMAGE_GLSL

// Images that a pass only reads. They are sampled images, which may have any format that holds such numbers; no fetch
// filters. Define GLOAM_STORAGE_INPUTS for storage images of the format that is declared: drivers that run on a CPU
// read these in less time (docs/cpu-drivers.md).
//   layout(binding = B GLOAM_FORMAT(r32f)) uniform GLOAM_INPUT image;
//   GLOAM_FETCH(image, pixel)    the texel, a vec4. pixel: an ivec2 inside the image

#ifdef GLOAM_STORAGE_INPUTS
#define GLOAM_FORMAT(format) , format
#define GLOAM_INPUT readonly highp image2D
#define GLOAM_FETCH(image, pixel) imageLoad(image, pixel)
#else
#define GLOAM_FORMAT(format)
#define GLOAM_INPUT highp sampler2D
#define GLOAM_FETCH(image, pixel) texelFetch(image, pixel, 0)
#endif

#endif
