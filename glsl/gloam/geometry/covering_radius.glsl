// SPDX-License-Identifier: MIT
#ifndef GLOAM_GEOMETRY_COVERING_RADIUS_GLSL
#define GLOAM_GEOMETRY_COVERING_RADIUS_GLSL

#include "gloam/geometry/background.glsl"
#include "gloam/geometry/finite.glsl"
#include "gloam/geometry/projected_radius.glsl"
#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/square_root.glsl"

// Radius of the image of a sampling disc (ISSAO-P), in units of the focal length: times P11 H / 2 it is in pixels.

// image of a disc parallel to the screen (ISSAO-P-parallel): `R / d` [ISSAO, section on the projected disc; derived].
// Its image is a circle, whatever the paper says of an ellipse.
// position: centre of the disc, view space, world units. radius: R, world units, >= 0. largest: upper bound of the
// result, >= 0.
// Returns a radius in [0, largest]; 0 for a position behind the eye or not finite and for R not positive or NaN.
// Error: 2.5 ULP.
float gloam_covering_radius_parallel(vec3 position, float radius, float largest) {
    if (!gloam_is_finite3(position) || gloam_is_background(-position.z) || !(radius > 0.0 && largest > 0.0)) return 0.0;
    float depth = clamp(-position.z, GLOAM_SMALLEST, GLOAM_LARGEST_DIVISOR);
    float r = radius / depth;
    return min(r, gloam_positive_length(largest));
}

// circle that covers the image of a disc across the view ray (ISSAO-P): `R / (cos t (d - R sin t))` [ISSAO, section on
// the projected disc; derived].
// The farthest point of its elliptic image from that of the centre; t is the angle off the axis. The reading under
// which the paper's ellipse and covering circle make sense; never below the other.
// position: centre of the disc, view space, world units, |position| within [1e-12, 1e12]. radius: R, world units, >= 0.
// largest: upper bound of the result, >= 0: the screen's diagonal.
// Returns a radius in [0, largest]; largest where the disc reaches the plane of the eye; 0 for a position behind the
// eye or not finite and for R not positive or NaN. Error: 8 ULP where R sin t is at most half of d; what the
// subtraction loses beyond.
float gloam_covering_radius_perpendicular(vec3 position, float radius, float largest) {
    if (!gloam_is_finite3(position) || gloam_is_background(-position.z) || !(radius > 0.0 && largest > 0.0)) return 0.0;
    float depth = -position.z;
    float across = gloam_sqrt(dot(position.xy, position.xy));
    float along = gloam_sqrt(dot(position, position));
    // sin t = across / along, cos t = depth / along.
    float denominator = (depth / along) * (depth - radius * (across / along));
    if (!(denominator >= GLOAM_SMALLEST)) return gloam_positive_length(largest);
    float r = radius / min(denominator, GLOAM_LARGEST_DIVISOR);
    return min(r, gloam_positive_length(largest));
}

#endif
