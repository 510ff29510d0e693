// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_ISSAO_DISTINCT_GLSL
#define GLOAM_METHODS_ISSAO_DISTINCT_GLSL

#include "gloam/methods/issao.glsl"

// ISSAO with the saving that its authors describe: several taps of a frame that fall into the same pixel, of 8 x 8
// around the shaded one, count once. Radii are uniform, so taps coincide near that pixel and where the radius is
// small in the image. The result is a mean over pixels, less dense near the point. A device that runs both sides of a
// branch saves no time.

// All samples of one pixel in one frame. Parameters and result are those of gloam_issao; settings.distinct is to be
// GLOAM_DISTINCT_TAPS, and the samples are the taps in different pixels.
GloamEstimate gloam_issao_distinct(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel,
                                   GloamIssao settings) {
    return gloam_issao(position, normal, camera, kernel, settings);
}

#endif
