// SPDX-License-Identifier: MIT
#ifndef GLOAM_GATHER_DISC_GLSL
#define GLOAM_GATHER_DISC_GLSL

#include "gloam/gather/fetch.glsl"
#include "gloam/gather/footprint.glsl"
#include "gloam/geometry/radius.glsl"
#include "gloam/numeric/constants.glsl"
#include "gloam/numeric/sincos.glsl"
#include "gloam/occlusion/gather_kernel.glsl"
#include "gloam/occlusion/proxies.glsl"
#include "gloam/sampling/disc.glsl"
#include "gloam/sampling/halton.glsl"
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
    return GloamCoveringDisc(footprint, parallel > 0.0 ? covering / parallel : 1.0,
                             gloam_sincos_turns(gloam_turns(angle)));
}

// Pixel that a tap reads.
// index: of the tap's Halton point, 1 for the first. Returns a pixel inside the image, the nearest where the tap lies
// outside. Error: none, but a tap within rounding of a pixel's border may fall to either side.
ivec2 gloam_covering_pixel(GloamCoveringDisc disc, uint index) {
    vec2 tap = gloam_issao_offset_polar(gloam_halton_point(index).yx, disc.stretch);
    return gloam_footprint_pixel(disc.footprint, gloam_turn_disc(tap, disc.turn));
}

// Lower bound of the cosine at which a surface is seen. A pixel at the outline of a surface would otherwise represent
// more area than there is.
const float GLOAM_DISC_LEAST_FACING = 0.05;

// Contribution of the surface at a pixel as a disc with the area that the pixel covers there (CS-S).
// at: inside the image. position: of the shaded point, view space, world units. normal: of it, unit. kernel: of it the
// radius and the bias count. axes: half-axes of the radius at the shaded point's depth, pixels.
// Returns a contribution in [0, 1]; 0 where the pixel shows nothing, for what lies beyond the radius and for what is
// no higher than the bias over the tangent plane. Error: 1e-6 of the disc's own.
float gloam_disc_piece(GloamFootprint footprint, ivec2 at, vec3 position, vec3 normal, GloamKernel kernel, vec2 axes) {
    float depth = gloam_fetch_depth(at);
    vec3 offset = gloam_footprint_position(footprint, at, depth) - position;
    bool counts = gloam_tap_sees(depth) && dot(offset, offset) <= kernel.radius * kernel.radius &&
                  dot(offset, normal) > kernel.bias;
    if (!counts) return 0.0;
    // Half-axes of the radius there, pixels: so large is a pixel in the world.
    vec2 size = axes * (footprint.orthographic ? 1.0 : -position.z / depth);
    size = kernel.radius / size;
    vec3 emitter = gloam_safe_normalize(gloam_fetch_normal(at), vec3(0.0));
    vec3 ray = vec3(footprint.orthographic ? vec2(0.0) : gloam_footprint_ray(footprint, at), -1.0);
    float area = size.x * size.y / max(-dot(emitter, ray), GLOAM_DISC_LEAST_FACING);
    return gloam_contribution_disc_proxy_cosine(offset, normal, emitter, area, 1.0);
}

#endif
