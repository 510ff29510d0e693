// SPDX-License-Identifier: MIT
#ifndef GLOAM_OCCLUSION_GATHER_KERNEL_GLSL
#define GLOAM_OCCLUSION_GATHER_KERNEL_GLSL

#include "gloam/geometry/camera.glsl"

// The common part of all methods of gloam/methods: their request, their result, and the test that rejects unusable
// points. After this test nothing overflows, and nothing is NaN except depths of taps, which gloam_tap_sees tests.

// The samples that one pixel takes in one frame: points first + 1 ... first + count of a Halton sequence (TSSAO-4). The
// last two members are options; if they are constants, the compiler removes the code for unused options.
struct GloamKernel {
    float radius;  // of influence, world units
    float bias;  // world units, ours where a source prints none: hides the rounding of positions and depths, so at
                 // least the spacing of depths (2^-23 of the depth in float32, 2^-10 in halves: 0.05 at 50 units). The
                 // presets use 1e-3 of the radius at any depth; bias_depth adds a lower limit as a share of the depth
    float angle;   // rotation of the kernel, radians: another for each pixel (gloam_hash_rotation); 0 once the pixel
                   // has converged (TSSAO-ROT)
    uint first;    // j, samples taken before; 0 without a history
    uint count;    // k: taps in all. Methods of slices take whole slices of 2 x steps taps, at least one: what is left
                   // of the division is not taken
    float farthest;   // world units: points, taps and slices further in front than this are rejected (CS-REJ);
                      // infinity: none is
};

// What a method estimates for a pixel: all that it samples there in one frame. Every method of gloam/methods is a
// function gloam_NAME(position, normal, camera, kernel), some with settings of their own; what is said here holds
// unless its comment differs.
// position: of the surface, view space, world units. normal: view space, of a length in [1e-15, 1e15].
// Where a tap lies outside the image, the nearest pixel counts. No samples where there is nothing to gather
// (gloam_can_gather). Error of the occlusion: that of the contributions, but for taps within rounding of a pixel's
// border.
// By points: of a ball, each moved along the tangent plane to the centre of its pixel (gloam_plane_depth); one behind
// the eye is not taken. Error: none, but a point within rounding of the blocking depth may fall to either side.
// By rays: steps lie evenly up to the radius (gloam_eye_march); background, the point's own pixel and steps that are
// not in front of the eye do not count.
// In pairs: of opposite taps; an odd number is taken as the even one above it.
struct GloamEstimate {
    float occlusion;  // mean of the samples, [0, 1]
    float samples;    // taken, an integer up to 2^24; 0 where there is nothing to shade
    float weight;     // of each sample, in a mean over frames or pixels, [0, pi / 2]: 1, but for slices
};

// No depth, position or length of a scene is as large: squares stay finite.
const float GLOAM_FARTHEST = 1e18;

// whether there is anything to gather at a point (TSSAO-2-can): `surface in front of the eye, |n| in [1e-15, 1e15],
// lengths and projection in [1e-18, 1e18]` [edges of TSSAO, eq 2].
// position: view space, world units. normal: view space, of a length in [1e-15, 1e15]. radius: world units.
// Returns false for background depth, for a normal of another length or NaN, for a radius that is not in [1e-18, 1e18],
// and for an image without pixels. Also where the position or an element of the camera is not finite or beyond 1e18, or
// an element is below 1e-18. Error: none, but for a normal within rounding of the limits.
bool gloam_can_gather(vec3 position, vec3 normal, float radius, GloamCamera camera) {
    vec2 p = abs(camera.p00_p11);
    float squared = dot(normal, normal);
    bool point = all(lessThanEqual(abs(position), vec3(GLOAM_FARTHEST))) && -position.z >= 1e-18;
    bool projects = p.x >= 1e-18 && p.y >= 1e-18 && p.x <= GLOAM_FARTHEST && p.y <= GLOAM_FARTHEST;
    bool sized = camera.size.x > 0 && camera.size.y > 0 && radius >= 1e-18 && radius <= GLOAM_FARTHEST;
    return point && projects && sized && squared >= 1e-30 && squared <= 1e30;
}

// Of a pixel with nothing to gather.
const GloamEstimate GLOAM_NO_ESTIMATE = GloamEstimate(0.0, 0.0, 1.0);

// estimate of a weighted mean (TSSAO-2-estimate): `min(sum / weight, 1)` [TSSAO, eq 2].
// occluded: sum of occlusion times weight, >= 0. whole: sum of weights, >= 0. samples: taken.
// Returns occlusion occluded / whole inside [0, 1]; 0 where nothing has a weight, and for NaN. Error: 2.5 ULP.
GloamEstimate gloam_estimate(float occluded, float whole, uint samples) {
    bool known = whole >= GLOAM_SMALLEST && occluded > 0.0;
    float mean = known ? (occluded < whole ? occluded / whole : 1.0) : 0.0;
    return GloamEstimate(mean, float(samples), 1.0);
}

// estimate of slices with weights (SLICE-estimate): `min(sum / weight, 1), of weight / slices` [the mean of Jimenez et
// al. 2016, over frames].
// A slice that hardly contains the normal says little of the point. In a mean with other frames or pixels it counts by
// its weight, so that the mean is the quotient of all sums and not the mean of quotients.
// occluded: sum of occlusion times weight, >= 0. whole: sum of weights, in [0, pi / 2] for each slice. slices: their
// number. steps: taps of a slice to each side, >= 1.
// Returns occlusion occluded / whole inside [0, 1], 2 slices steps samples, and their mean weight; occlusion and weight
// 0 where nothing has a weight. Error: 2.5 ULP.
GloamEstimate gloam_slice_estimate(float occluded, float whole, uint slices, uint steps) {
    GloamEstimate estimate = gloam_estimate(occluded, whole, slices * 2u * steps);
    estimate.weight = whole / float(max(slices, 1u));
    return estimate;
}

// whether a depth is that of a surface (TSSAO-2-sees): `1e-18 <= d <= 1e18` [definition].
// False for 0, what is negative, below 1e-18, beyond 1e18, infinite or NaN. Error: none.
bool gloam_tap_sees(float depth) {
    return depth >= 1e-18 && depth <= GLOAM_FARTHEST;
}

#endif
