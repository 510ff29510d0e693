// SPDX-License-Identifier: MIT
#ifndef GLOAM_PASSES_INPUT_IMAGE_GLSL
#define GLOAM_PASSES_INPUT_IMAGE_GLSL

// What all passes of this folder share. Dispatch ceil(invocations / 8) groups: one invocation a pixel, unless a pass
// says another number. Bindings are those of descriptor set 0. depth_image is eye-linear depth, world units, background
// 0 or not finite; normal_image the view-space normal facing the eye, in xyz.
layout(local_size_x = 8, local_size_y = 8) in;

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
