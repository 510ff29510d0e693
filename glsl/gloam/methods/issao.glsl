// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_ISSAO_GLSL
#define GLOAM_METHODS_ISSAO_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/occlusion/disc_taps.glsl"

// Where ISSAO's taps lie: in the circle that covers the image of a disc across the view ray (ISSAO-P), radii uniform
// (ISSAO-1, polar reading).
struct GloamCoveringDisc {
    GloamFootprint footprint;
    float stretch;  // radius of the circle over that of the disc parallel to the screen
    vec2 turn;      // (cos, sin) of the kernel's angle
};

// Computed once a pixel; only for what gloam_can_gather lets pass.
// position: of the surface, view space, world units. radius: of influence, world units. angle: of the kernel, radians.
// Error of the stretch: 4e-6.
GloamCoveringDisc gloam_covering_disc(vec3 position, float radius, float angle, GloamCamera camera) {
    GloamFootprint footprint = gloam_footprint(position, radius, camera);
    float parallel = gloam_covering_radius_parallel(position, radius, GLOAM_LARGEST);
    // No circle covers more than four times the disc parallel to the screen.
    float covering = gloam_covering_radius_perpendicular(position, radius, 4.0 * parallel);
    return GloamCoveringDisc(footprint, covering / parallel, gloam_sincos_turns(gloam_turns(angle)));
}

// Pixel that a tap reads (gloam_footprint_pixel). index: of the tap's Halton point, 1 for the first.
ivec2 gloam_covering_pixel(GloamCoveringDisc disc, uint index) {
    vec2 tap = gloam_issao_offset_polar(gloam_halton_point(index).yx, disc.stretch);
    return gloam_footprint_pixel(disc.footprint, gloam_turn_disc(tap, disc.turn));
}

// The pixels around the shaded one that the taps have read. Taps in the same pixel read the same depth, so one of them
// is enough (ISSAO, in prose). With uniform radii such taps are near the shaded pixel. A bit for each of the 8 x 8
// pixels around it makes these distinct. (Searching a list of the pixels read took ten times as long as the saved
// taps.)
struct GloamDistinctPixels {
    ivec2 center;  // the shaded pixel; the others lie 4 to its left and above, 3 to its right and below
    uvec2 seen;    // a bit for each pixel: four rows of 8, and four more; 0 before the first tap
};

// Adds the pixel of a tap.
// Returns false for a pixel of those 8 x 8 that was added before, else true. Error: none.
bool gloam_distinct_add(inout GloamDistinctPixels known, ivec2 pixel) {
    ivec2 at = pixel - known.center + 4;
    if (at.x < 0 || at.y < 0 || at.x > 7 || at.y > 7) return true;
    uint bit = 1u << uint((at.y & 3) * 8 + at.x);
    uvec2 bits = at.y < 4 ? uvec2(bit, 0u) : uvec2(0u, bit);
    bool fresh = (known.seen & bits) == uvec2(0u);
    known.seen |= bits;
    return fresh;
}

// ISSAO, the improved screen-space ambient occlusion, reconstructed: surface points under the circle that covers the
// image of a disc across the view ray (ISSAO-P). Radii are uniform (ISSAO-1, polar reading). Each point counts phi (v
// . n - psi) / (v . v + sigma) (ISSAO-6). The kernel's bias is psi: a constant, or psi(z) of gloam_depth_bias.
struct GloamIssao {
    float epsilon;    // root of sigma, world units
    float intensity;  // lambda phi as a share of the radius
    bool distinct;    // GLOAM_EVERY_TAP or GLOAM_DISTINCT_TAPS
};

const bool GLOAM_EVERY_TAP = false;
const bool GLOAM_DISTINCT_TAPS = true;  // several taps in one pixel count once (gloam_distinct_add)

// occlusion by surface points under the covering circle (METHOD-issao): `mean of phi max(v . n - psi, 0) / (v . v +
// sigma), |v| < R` [ISSAO, eqs 1 and 6].
// All samples of one pixel in one frame; its samples are the taps that counted.
GloamEstimate gloam_issao(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel, GloamIssao settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamCoveringDisc disc = gloam_covering_disc(position, kernel.radius, kernel.angle, camera);
    float phi = settings.intensity * kernel.radius;
    GloamDistinctPixels known = GloamDistinctPixels(disc.footprint.pixel, uvec2(0u));
    float sum = 0.0;
    uint taken = 0u;
    for (uint i = 0u; i < kernel.count; ++i) {
        ivec2 at = gloam_covering_pixel(disc, kernel.first + i + 1u);
        if (settings.distinct && !gloam_distinct_add(known, at)) continue;
        float depth = gloam_fetch_depth(at);
        if (gloam_tap_rejected(-position.z, depth, kernel.farthest)) continue;
        vec3 offset = gloam_footprint_position(disc.footprint, at, depth) - position;
        float counted = gloam_contribution_issao(offset, n, kernel.radius, phi, kernel.bias,
                                                 settings.epsilon * settings.epsilon);
        sum += gloam_tap_sees(depth) ? counted : 0.0;
        ++taken;
    }
    return gloam_estimate(sum, float(taken), taken);
}

// ISSAO with its attenuation by distance (ISSAO-4 and ISSAO-5, the right half of its figure 4). With the taps of
// issao, every surface within the radius counts Q(|v|) times its cosine. The mean stands for the integral in the same
// way as in issao. Both methods agree where |v| is large against mu and the bias small against v . n.
// Print counts all sample points. Here what lies no higher over the tangent plane than the kernel's bias counts 0,
// because the rounding of depths would darken bare planes.
struct GloamIssaoAttenuated {
    float epsilon;    // mu, world units: bounds the distance from below
    float intensity;  // phi as a share of the radius
};

// issao by cosine and attenuation (METHOD-issao_attenuated): `mean of Q(|v|) cos(v, n), |v| < R` [ISSAO, eqs 4 and 5].
GloamEstimate gloam_issao_attenuated(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel,
                                     GloamIssaoAttenuated settings) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamCoveringDisc disc = gloam_covering_disc(position, kernel.radius, kernel.angle, camera);
    float phi = settings.intensity * kernel.radius;
    float sum = 0.0;
    uint taken = 0u;
    for (uint i = 0u; i < kernel.count; ++i) {
        ivec2 at = gloam_covering_pixel(disc, kernel.first + i + 1u);
        float depth = gloam_fetch_depth(at);
        if (gloam_tap_rejected(-position.z, depth, kernel.farthest)) continue;
        ++taken;
        vec3 offset = gloam_footprint_position(disc.footprint, at, depth) - position;
        if (!(gloam_tap_sees(depth) && dot(offset, n) > kernel.bias)) continue;
        sum += gloam_contribution_issao_attenuated(offset, n, kernel.radius, phi, settings.epsilon);
    }
    return gloam_estimate(sum, float(taken), taken);
}

// ISSAO with the saving that its authors describe: several taps of a frame that fall into the same pixel count once
// (GloamDistinctPixels). The result is a mean over pixels, less dense near the point. A device that runs both sides of
// a branch saves no time.

// issao, taps in one pixel counted once (METHOD-issao_distinct): `mean over pixels of phi max(v . n - psi, 0) / (v . v
// + sigma)` [ISSAO, section 5 (1)].
// All samples of one pixel in one frame. Parameters and result are those of gloam_issao; settings.distinct is to be
// GLOAM_DISTINCT_TAPS, and the samples are the taps in different pixels.
GloamEstimate gloam_issao_distinct(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel,
                                   GloamIssao settings) {
    return gloam_issao(position, normal, camera, kernel, settings);
}

// ISSAO before its attenuation (ISSAO-3, the left half of its figure 4). With the taps of issao, every surface within
// the radius counts its cosine, whatever its distance. The mean stands for the integral in the same way as in issao,
// and as in gloam_issao_attenuated what is no higher than the bias counts 0, where print counts all sample points.

// issao by cosine alone (METHOD-issao_basic): `mean of cos(v, n), |v| < R` [ISSAO, eq 3].
GloamEstimate gloam_issao_basic(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamCoveringDisc disc = gloam_covering_disc(position, kernel.radius, kernel.angle, camera);
    float sum = 0.0;
    uint taken = 0u;
    for (uint i = 0u; i < kernel.count; ++i) {
        ivec2 at = gloam_covering_pixel(disc, kernel.first + i + 1u);
        float depth = gloam_fetch_depth(at);
        if (gloam_tap_rejected(-position.z, depth, kernel.farthest)) continue;
        ++taken;
        vec3 offset = gloam_footprint_position(disc.footprint, at, depth) - position;
        if (!(gloam_tap_sees(depth) && dot(offset, n) > kernel.bias)) continue;
        sum += gloam_contribution_issao_basic(offset, n, kernel.radius);
    }
    return gloam_estimate(sum, float(taken), taken);
}

#endif
