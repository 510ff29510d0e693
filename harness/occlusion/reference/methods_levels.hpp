// SPDX-License-Identifier: MIT
#pragma once

#include "reference/methods_discs.hpp"
#include "reference/methods_pairs.hpp"
#include "reference/methods_slices.hpp"

// Methods that read results or surfaces of lower resolutions, and those whose pixels are balls or discs.
namespace gloam::reference {

// Where passes keep texel and kind of a level (gloam/gather/pixels.glsl).
inline glm::ivec2 level_size(glm::ivec2 size, int level) {
    return (size + (1 << level) - 1) / (1 << level);
}
inline dvec4 pyramid_texel(const ShadedPoint& at, glm::ivec2 texel, int level, int kind) {
    texel += level_size(at.camera.size, level) * glm::ivec2(kind % 2, kind / 2);
    for (int l = 1; l < level; ++l) texel += level_size(at.camera.size, l);
    return at.images.prepared(texel);
}

struct GloamDualResolution {
    double angle_bias;
    double contrast;
    unsigned steps;
    double disagreement;
    int layers;
};
// hbao over all layers.
inline GloamEstimate layered_horizons(const ShadedPoint& at, const GloamDualResolution& own) {
    return horizons(
        at, std::max(own.steps, 1U), squared_place,
        [&](dvec2 direction) { return hbao_start(at, direction, own.angle_bias); },
        [&](const Tap& first) {
            std::vector<Tap> taps;
            for (int layer = 0; layer < own.layers; ++layer)
                taps.push_back(at.tap(first.pixel, at.depth(first.pixel, layer)));
            return taps;
        },
        own.angle_bias, own.contrast);
}
// The small image at the pixel where its 3 x 3 texels agree and enough of the four nearest lie on the
// surface.
inline GloamEstimate gloam_dual_resolution(const ShadedPoint& at, const GloamDualResolution& own) {
    const glm::ivec2 small = gloam_half_size(at.camera.size);
    const auto occlusion = [&](glm::ivec2 texel) { return at.images.prepared(texel).x; };
    if (gloam_dual_resolution_disagrees(at.pixel / 2, small, own.disagreement, occlusion))
        return layered_horizons(at, own);
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    for (int i = 0; i < 4; ++i) {
        const glm::ivec2 texel = min(at.pixel / 2 + glm::ivec2(i % 2, i / 2), small - 1);
        const dvec2 along = dvec2(at.pixel % 2) / 2.0;
        const double share = (i % 2 == 0 ? 1.0 - along.x : along.x) * (i / 2 == 0 ? 1.0 - along.y : along.y);
        const Tap tap = at.tap(gloam_half_source(texel));
        if (!tap.surface || !(share > 0.0)) continue;
        const dvec4 known = at.images.prepared(texel);
        const dvec3 facing = gloam_safe_normalize({known.y, known.z, known.w}, dvec3(0.0));
        const double weight = gloam_mssao_upsample_weight(share, at.height(tap) / (0.02 * at.kernel.radius),
                                                          dot(facing, at.normal), 2.0, 8.0);
        mean = gloam_weighted_mean_add(mean, known.x, weight);
    }
    if (mean.weight < 0.25) return layered_horizons(at, own);
    const unsigned unit = 2U * std::max(own.steps, 1U);
    return {gloam_weighted_mean_value(mean, 0.0),
            static_cast<double>(gloam_whole_samples(at.kernel.count, unit))};
}

struct GloamMssao {
    unsigned resolutions;
};
// (largest, mean, count) of the coarser levels, from the four texels of the first around the point.
inline dvec3 coarser_levels(const ShadedPoint& at, int levels) {
    if (levels < 1) return dvec3(0.0);
    const dvec2 place = at.uv * dvec2(at.camera.size) / 2.0 - 0.5;
    dvec3 sums(0.0);
    dvec3 weights(0.0);
    for (int i = 0; i < 4; ++i) {
        const glm::ivec2 texel = glm::ivec2(floor(place)) + glm::ivec2(i % 2, i / 2);
        if (!has_pixel(level_size(at.camera.size, 1), texel)) continue;
        const dvec3 surface = pyramid_texel(at, texel, 1, 0);
        if (!(surface.z < 0.0)) continue;
        const dvec2 share = 1.0 - abs(dvec2(texel) - place);
        const double height = dot(surface - at.position, at.normal) / (0.05 * at.kernel.radius);
        const double facing = dot(dvec3(pyramid_texel(at, texel, 1, 1)), at.normal);
        const double weight = gloam_mssao_upsample_weight(share.x * share.y, height, facing, 2.0, 8.0);
        const dvec3 known = dvec3(pyramid_texel(at, texel, 1, 2)) / dvec3(1.0, 1.0, levels);
        for (int k = 0; k < 3; ++k) {
            if (!(known[k] >= 0.0 && known[k] <= 1.0 && weight > 0.0)) continue;
            sums[k] += weight * known[k];
            weights[k] += weight;
        }
    }
    for (int k = 0; k < 3; ++k) sums[k] = weights[k] >= 1e-8 ? sums[k] / weights[k] : 0.0;
    return sums * dvec3(1.0, 1.0, levels);
}
// The finest resolution: a disc of at most 6 pixels.
inline GloamEstimate gloam_mssao(const ShadedPoint& at, const GloamMssao& own) {
    const dvec2 pixels = at.axes * dvec2(at.camera.size);
    const double shrunk = min(6.0 / max(pixels.x, pixels.y), 1.0);
    std::vector<dvec2> places = disc_places(at.kernel);
    for (dvec2& place : places) place *= shrunk;
    dvec2 finest(0.0);
    for (const Tap& tap : taps_at(at, places)) {
        const bool counts = tap.surface && at.height(tap) > at.kernel.bias;
        const double seen = counts ? gloam_contribution_mssao(tap.offset, at.normal, at.kernel.radius) : 0.0;
        finest += dvec2(seen, 1.0);
    }
    const double occlusion = finest.y > 0.0 ? gloam_unit_interval(finest.x / finest.y) : 0.0;
    const dvec3 coarser = coarser_levels(at, static_cast<int>(std::clamp(own.resolutions, 1U, 9U)) - 1);
    const double mean = (occlusion + coarser.z * coarser.y) / (1.0 + coarser.z);
    return {gloam_mssao_combine(max(occlusion, coarser.x), gloam_unit_interval(mean)),
            static_cast<double>(at.kernel.count)};
}

// The solid part of the chord at a place over the block around it, whose heights are spread evenly with the
// block's mean and variance.
inline double block_solid(const ShadedPoint& at, dvec2 place, int level) {
    const glm::ivec2 texel = at.under(place) / (1 << level);
    GloamSurfaceMoments seen = gloam_moments_empty();
    if (level > 0) {
        const dvec4 mean = pyramid_texel(at, texel, level, 0);
        seen = {mean.w, mean, pyramid_texel(at, texel, level, 1), pyramid_texel(at, texel, level, 2)};
    } else if (const Tap tap = at.tap(texel); tap.surface) {
        seen = gloam_moments_of(at.position + tap.offset);
    }
    if (!(seen.weight > 0.0)) return 0.0;
    const glm::ivec2 pixels = min(at.camera.size - texel * (1 << level), glm::ivec2(1 << level));
    const double height = height_over(at, place, seen.mean - at.position);
    const double spread =
        sqrt(3.0 * gloam_moments_along(seen, at.normal)) / max(dot(at.view, at.normal), 1e-4);
    return seen.weight / (pixels.x * pixels.y) *
           gloam_area_occlusion(height, spread, gloam_chord_half_height(place, at.kernel.radius));
}
inline GloamEstimate gloam_volumetric_area(const ShadedPoint& at) {
    const double block = sqrt(at.disc_pixels() / std::max(gloam_paired_samples(at.kernel.count), 1U));
    const int level = gloam_depth_mip_level(block, 2.0, 6);
    return mean_of_pairs(at, [&](dvec2 place) {
        const double solid = block_solid(at, place, level) + block_solid(at, -place, level);
        return gloam_chord_half_height(place, at.kernel.radius) * dvec2(solid, 2.0);
    });
}

// The sum of piece(tap, size of its pixel in the world) over the pixels of the disc but the point's own, from
// taps of density 1 / (2 pi rho): each stands for 2 rho times the disc's pixels. What lies beyond the radius
// or no higher than the bias counts nothing.
template <class Piece>
double sum_of_pixels(const ShadedPoint& at, const Piece& piece) {
    double sum = 0.0;
    for (unsigned i = 1; i <= at.kernel.count; ++i) {
        const dvec2 random = gloam_halton_2d(at.kernel.first + i);
        const dvec2 place = gloam_rotate_disc(random.y * gloam_circle_point(random.x), at.kernel.angle);
        const Tap tap = at.tap(at.under(place));
        const bool counts = tap.surface && tap.pixel != at.pixel && length(tap.offset) <= at.kernel.radius &&
                            at.height(tap) > at.kernel.bias;
        if (!counts) continue;
        const double depth = -(at.position + tap.offset).z;
        const dvec2 radius = gloam_camera_radius(at.kernel.radius, depth, at.camera);
        const dvec2 size = at.kernel.radius / (radius * dvec2(at.camera.size));
        sum += 2.0 * random.y * at.disc_pixels() * piece(tap, size);
    }
    return sum;
}

struct GloamSphereProxy {
    double intensity;
};
inline GloamEstimate gloam_sphere_proxy(const ShadedPoint& at, const GloamSphereProxy& own) {
    const double sum = sum_of_pixels(at, [&](const Tap& tap, dvec2 size) {
        return gloam_contribution_sphere_cosine(tap.offset, at.normal, sqrt(size.x * size.y) / 2.0);
    });
    return gloam_estimate(own.intensity * sum, at.kernel.count, at.kernel.count);
}

struct GloamMixture {
    double angle_bias;
    double intensity;
};
inline GloamEstimate gloam_mixture(const ShadedPoint& at, const GloamMixture& own) {
    const double sum = sum_of_pixels(at, [&](const Tap& tap, dvec2 size) {
        const dvec3 across = gloam_safe_normalize({tap.offset.x, tap.offset.y, 0.0}, dvec3(0.0));
        const dvec2 horizon = gloam_hbao_horizon(at.normal, across, on_circle(own.angle_bias));
        return gloam_above_horizon(tap.offset, horizon.y / max(horizon.x, 1e-6)) *
               gloam_falloff_linear(length(tap.offset), at.kernel.radius) *
               gloam_contribution_sphere(tap.offset, at.normal, sqrt(size.x * size.y) / 2.0);
    });
    return gloam_estimate(own.intensity * sum, at.kernel.count, at.kernel.count);
}

struct GloamDiscProxy {
    double intensity;
};
// The surface under a pixel as a disc of its area.
inline double disc_piece(const ShadedPoint& at, const Tap& tap, dvec2 size) {
    const dvec3 emitter = gloam_safe_normalize(at.images.normal(tap.pixel), dvec3(0.0));
    const dvec3 ray = gloam_camera_position(tap.pixel, 1.0, at.camera) *
                      dvec3(dvec2(at.camera.orthographic ? 0.0 : 1.0), 1.0);
    const double area = size.x * size.y / max(-dot(emitter, ray), 0.05);
    return gloam_contribution_disc_proxy_cosine(tap.offset, at.normal, emitter, area, 1.0);
}
inline GloamEstimate gloam_disc_proxy(const ShadedPoint& at, const GloamDiscProxy& own) {
    const double sum =
        sum_of_pixels(at, [&](const Tap& tap, dvec2 size) { return disc_piece(at, tap, size); });
    return gloam_estimate(own.intensity * sum, at.kernel.count, at.kernel.count);
}
// Each disc by its visibility, from half of the samples.
inline GloamEstimate gloam_disc_proxy_two(const ShadedPoint& whole, const GloamDiscProxy& own) {
    GloamKernel half = whole.kernel;
    half.first /= 2U;
    half.count = gloam_paired_samples(half.count) / 2U;
    const ShadedPoint at = whole.with(half);
    const double sum = sum_of_pixels(at, [&](const Tap& tap, dvec2 size) {
        return gloam_unit_interval(at.images.prepared(tap.pixel).x) * disc_piece(at, tap, size);
    });
    return gloam_estimate(own.intensity * sum, half.count, 2U * half.count);
}

}  // namespace gloam::reference
