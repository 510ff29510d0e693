// SPDX-License-Identifier: MIT
#ifndef GLOAM_METHODS_VOLUMETRIC_AREA_GLSL
#define GLOAM_METHODS_VOLUMETRIC_AREA_GLSL

#include "gloam/gather/method.glsl"
#include "gloam/gather/pair.glsl"
#include "gloam/gather/pixels.glsl"
#include "gloam/geometry/surface.glsl"
#include "gloam/sampling/depth_mip.glsl"

// Volumetric obscurance by area samples (Loos and Sloan 2010, reconstructed): the ball of volumetric, but a sample is
// a block of pixels. A pass prepares the mean and the variance of each block (preparation/area_moments.comp). The
// surface of a block is taken to be spread evenly over an interval of heights with that mean and variance. Blocks are
// so large that all samples together cover the disc, so few samples miss nothing. But a block does not say on which
// side a near surface is. Pairs are opposite, so that a tilted plane stays at 1/2, but no sample of a pair is
// rejected, so objects in front have a halo.

const int GLOAM_AREA_MEANS = 0;
const int GLOAM_AREA_VARIANCES = 1;
const int GLOAM_AREA_COVARIANCES = 2;

// The last level: blocks of 64 x 64 pixels.
const int GLOAM_LAST_AREA_LEVEL = 6;

// Moments of a block. level: 0 for a pixel. texel: of that level, inside it. footprint: of any point in the image.
GloamSurfaceMoments gloam_area_moments(ivec2 texel, int level, GloamFootprint footprint) {
    if (level == 0) {
        float depth = gloam_fetch_depth(texel);
        return gloam_tap_sees(depth) ? gloam_moments_of(gloam_footprint_position(footprint, texel, depth))
                                     : gloam_moments_empty();
    }
    ivec2 size = ivec2(footprint.size);
    vec4 mean = gloam_fetch_prepared(gloam_pyramid_texel(texel, level, size, GLOAM_AREA_MEANS));
    ivec2 variance = gloam_pyramid_texel(texel, level, size, GLOAM_AREA_VARIANCES);
    ivec2 covariance = gloam_pyramid_texel(texel, level, size, GLOAM_AREA_COVARIANCES);
    return GloamSurfaceMoments(mean.w, mean.xyz, gloam_fetch_prepared(variance).xyz,
                               gloam_fetch_prepared(covariance).xyz);
}

// Level whose blocks are as large as a sample's part of the disc, or up to half as wide.
// axes: half-axes of the disc, pixels. samples: of the disc, at least 1.
int gloam_area_level(vec2 axes, uint samples) {
    float side = gloam_sqrt(GLOAM_PI * axes.x * axes.y / float(samples));
    return gloam_depth_mip_level(side, 2.0, GLOAM_LAST_AREA_LEVEL);
}

// Solid part of the chord at a tap, over the block around it: background is empty.
float gloam_area_solid(GloamLinePoint point, vec2 tap, float radius, int level, GloamCamera camera) {
    ivec2 texel = gloam_footprint_pixel(point.footprint, tap) >> level;
    GloamSurfaceMoments seen = gloam_area_moments(texel, level, point.footprint);
    if (!(seen.weight > 0.0)) return 0.0;
    ivec2 pixels = min(camera.size - (texel << level), ivec2(1 << level));
    vec3 aim = vec3(radius * tap * point.upright, 0.0);
    float height = gloam_height_at(seen.mean - point.position, aim, point.normal, point.facing);
    float half_width = gloam_sqrt(3.0 * gloam_moments_along(seen, point.normal)) / point.facing;
    float share = seen.weight / float(pixels.x * pixels.y);
    return share * gloam_area_occlusion(height, half_width, gloam_chord_half_height(tap, radius));
}

// volumetric by the moments of blocks (METHOD-volumetric_area): `mean of the solid share of blocks weighted by h_i`
// [Loos and Sloan 2010, CS-I].
// All samples of one pixel in one frame, in pairs. gloam_fetch_prepared: mean and weight, variance, covariance of
// blocks (gloam_area_moments). Error: that of the moments and of gloam_area_occlusion, but for taps within rounding of
// a block's border.
GloamEstimate gloam_volumetric_area(vec3 position, vec3 normal, GloamCamera camera, GloamKernel kernel) {
    if (!gloam_can_gather(position, normal, kernel.radius, camera)) return GLOAM_NO_ESTIMATE;
    vec3 n = normalize(normal);
    GloamLinePoint point = gloam_line_point(position, n, kernel.radius, camera);
    vec2 turn = gloam_sincos_turns(gloam_turns(kernel.angle));
    uint samples = gloam_paired_samples(kernel.count);
    int level = gloam_area_level(point.footprint.reach * point.footprint.size, max(samples, 1u));
    float occluded = 0.0;
    float whole = 0.0;
    for (uint i = 0u; i < kernel.count; i += 2u) {
        vec2 tap = gloam_turn_disc(gloam_disc_point((kernel.first + i) / 2u + 1u).xy, turn);
        float chord = gloam_chord_half_height(tap, kernel.radius);
        float first = gloam_area_solid(point, tap, kernel.radius, level, camera);
        float second = gloam_area_solid(point, -tap, kernel.radius, level, camera);
        occluded += chord * (first + second);
        whole += 2.0 * chord;
    }
    return gloam_estimate(occluded, whole, samples);
}

#endif
