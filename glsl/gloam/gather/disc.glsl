// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_DISC_GLSL
#define GLOAM_GATHER_DISC_GLSL

#include "gloam/gather/footprint.glsl"
#include "gloam/sampling/disc.glsl"
#include "gloam/sampling/rotation.glsl"

// Where ISSAO's taps lie: in the circle that covers the image of a disc across the view ray (ISSAO-P), radii uniform
// (ISSAO-1, polar reading).
struct GloamCoveringDisc {
    GloamFootprint footprint;
    float stretch;  // radius of the circle over that of the disc parallel to the screen
    vec2 turn;      // (cos, sin) of the kernel's angle
};

// No circle covers more than this many times the disc parallel to the screen.
const float GLOAM_ISSAO_MOST_STRETCH = 4.0;

// Computed once a pixel; only for what gloam_can_gather lets pass.
// position: of the surface, view space, world units. radius: of influence, world units. angle: of the kernel, radians.
// Error of the stretch: 4e-6.
GloamCoveringDisc gloam_covering_disc(vec3 position, float radius, float angle, GloamCamera camera) {
    GloamFootprint footprint = gloam_footprint(position, radius, camera);
    float parallel = gloam_covering_radius_parallel(position, radius, GLOAM_LARGEST);
    float covering = gloam_covering_radius_perpendicular(position, radius, GLOAM_ISSAO_MOST_STRETCH * parallel);
    return GloamCoveringDisc(footprint, covering / parallel, gloam_sincos_turns(gloam_turns(angle)));
}

// Pixel that a tap reads.
// index: of the tap's Halton point, 1 for the first. Returns a pixel inside the image, the nearest where the tap lies
// outside. Error: none, but a tap within rounding of a pixel's border may fall to either side.
ivec2 gloam_covering_pixel(GloamCoveringDisc disc, uint index) {
    vec2 tap = gloam_issao_offset_polar(gloam_halton_point(index).yx, disc.stretch);
    return gloam_footprint_pixel(disc.footprint, gloam_turn_disc(tap, disc.turn));
}

#endif
