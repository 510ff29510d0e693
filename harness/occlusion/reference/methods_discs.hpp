// SPDX-License-Identifier: MIT
#pragma once

#include "reference/shaded_point.hpp"

// Methods that take a mean over surface points under a disc.
namespace gloam::reference {

struct GloamDisc {
    double epsilon;
};
// One beyond the radius, or no higher than the bias above the tangent plane, contributes nothing.
inline GloamEstimate gloam_disc(const ShadedPoint& at, const GloamDisc& own) {
    return mean_of_taps(taps_at(at, disc_places(at.kernel)), [&](const Tap& tap) {
        const bool counts = length(tap.offset) <= at.kernel.radius && at.height(tap) > at.kernel.bias;
        return counts ? gloam_contribution_fox_compton(tap.offset, at.normal, own.epsilon) : 0.0;
    });
}

struct GloamAlchemy {
    double epsilon;
    double intensity;
};
inline GloamEstimate gloam_alchemy(const ShadedPoint& at, const GloamAlchemy& own) {
    return mean_of_taps(taps_at(at, disc_places(at.kernel)), [&](const Tap& tap) {
        return gloam_contribution_alchemy(tap.offset, at.normal, at.kernel.bias, pow(own.epsilon, 2),
                                          2.0 * own.intensity * at.kernel.radius);
    });
}

inline GloamEstimate gloam_aksoy_phaneuf(const ShadedPoint& at) {
    return mean_of_taps(taps_at(at, disc_places(at.kernel)), [&](const Tap& tap) {
        return gloam_contribution_aksoy_phaneuf(tap.offset, at.normal, at.kernel.radius, at.kernel.bias);
    });
}

// Half of the samples within `share` of the radius, half within all of it: unit samples belong together.
template <class Method, class Both>
GloamEstimate at_two_radii(const ShadedPoint& at, unsigned count, double share, const Method& method,
                           const Both& both) {
    GloamKernel half = at.kernel;
    half.first /= 2U;
    half.count = count / 2U;
    const GloamEstimate broad = method(at.with(half));
    half.radius *= share;
    const ShadedPoint near = at.with(half);
    const GloamEstimate fine = near.gathers ? method(near) : GloamEstimate{};
    if (!(broad.samples > 0.0)) return {};
    return {both(fine.occlusion, broad.occlusion), static_cast<double>(count)};
}
inline GloamEstimate gloam_aksoy_phaneuf_two(const ShadedPoint& at) {
    return at_two_radii(at, gloam_paired_samples(at.kernel.count), 0.25, gloam_aksoy_phaneuf,
                        gloam_two_radii_sum);
}

struct GloamSao {
    double epsilon;
    double intensity;
    double mip_distance;
};
// Pixels of the spiral of a frame, and what each of its taps counts.
inline std::vector<glm::ivec2> spiral_pixels(const ShadedPoint& at) {
    const unsigned frame = at.kernel.first / std::max(at.kernel.count, 1U);
    const double turn = 2.0 * pi * (gloam_turns(at.kernel.angle) + gloam_radical_inverse(frame, 2U));
    const int count = static_cast<int>(at.kernel.count);
    std::vector<glm::ivec2> pixels;
    for (int i = 0; i < count; ++i)
        pixels.push_back(at.under(gloam_rotate_disc(gloam_spiral_point(i, count, 7), turn)));
    return pixels;
}
inline GloamEstimate mean_of_spiral(const ShadedPoint& at, const GloamSao& own,
                                    const std::vector<Tap>& taps) {
    return mean_of_taps(taps, [&](const Tap& tap) {
        return gloam_contribution_sao(tap.offset, at.normal, at.kernel.radius, at.kernel.bias,
                                      pow(own.epsilon, 2), 5.0 * own.intensity * at.kernel.radius);
    });
}
inline GloamEstimate gloam_sao(const ShadedPoint& at, const GloamSao& own) {
    std::vector<Tap> taps;
    for (const glm::ivec2 pixel : spiral_pixels(at))
        taps.push_back(at.tap(gloam_tap_pixel(pixel, at.pixel, at.camera.size, own.mip_distance)));
    return mean_of_spiral(at, own, taps);
}
// Levels 2 and up stand below one another, to the right of level 1.
inline GloamEstimate gloam_sao_chain(const ShadedPoint& at, const GloamSao& own) {
    const glm::ivec2 size = at.camera.size;
    std::vector<Tap> taps;
    for (const glm::ivec2 pixel : spiral_pixels(at)) {
        const glm::ivec2 apart = glm::abs(pixel - at.pixel);
        const int level =
            gloam_depth_mip_level(std::max(apart.x, apart.y), own.mip_distance, gloam_last_tap_level);
        glm::ivec2 texel = gloam_depth_mip_pixel(pixel, size, level);
        const glm::ivec2 source = gloam_depth_mip_source(texel, size, level);
        if (level > 1) texel.x += gloam_depth_mip_size(size, 1).x;
        for (int l = 2; l < level; ++l) texel.y += gloam_depth_mip_size(size, l).y;
        taps.push_back(level == 0 ? at.tap(pixel) : at.tap(source, at.images.prepared(texel).x));
    }
    return mean_of_spiral(at, own, taps);
}

struct GloamIssao {
    double epsilon;
    double intensity;
    bool distinct;
};
// Taps under the circle that covers the image of the disc across the view ray.
inline std::vector<Tap> covering_taps(const ShadedPoint& at) {
    const double parallel = gloam_covering_radius_parallel(at.position, at.kernel.radius, float_max);
    const double covering =
        gloam_covering_radius_perpendicular(at.position, at.kernel.radius, 4.0 * parallel);
    std::vector<dvec2> places;
    for (unsigned i = 1; i <= at.kernel.count; ++i) {
        const dvec2 random = gloam_halton_2d(at.kernel.first + i);
        const dvec2 place = gloam_issao_offset_polar({random.y, random.x}, covering / parallel);
        places.push_back(gloam_rotate_disc(place, at.kernel.angle));
    }
    return taps_at(at, places);
}
inline GloamEstimate gloam_issao(const ShadedPoint& at, const GloamIssao& own) {
    std::vector<Tap> taps;
    for (const Tap& tap : covering_taps(at)) {
        const bool near = clamp(tap.pixel - at.pixel, -4, 3) == tap.pixel - at.pixel;
        const bool known = std::ranges::find(taps, tap.pixel, &Tap::pixel) != taps.end();
        if (!(own.distinct && near && known)) taps.push_back(tap);
    }
    return mean_of_taps(taps, [&](const Tap& tap) {
        return gloam_contribution_issao(tap.offset, at.normal, at.kernel.radius,
                                        own.intensity * at.kernel.radius, at.kernel.bias,
                                        pow(own.epsilon, 2));
    });
}
inline GloamEstimate gloam_issao_distinct(const ShadedPoint& at, const GloamIssao& own) {
    return gloam_issao(at, own);
}

struct GloamIssaoAttenuated {
    double epsilon;
    double intensity;
};
inline GloamEstimate gloam_issao_attenuated(const ShadedPoint& at, const GloamIssaoAttenuated& own) {
    return mean_of_taps(covering_taps(at), [&](const Tap& tap) {
        return at.height(tap) > at.kernel.bias
                   ? gloam_contribution_issao_attenuated(tap.offset, at.normal, at.kernel.radius,
                                                         own.intensity * at.kernel.radius, own.epsilon)
                   : 0.0;
    });
}

inline GloamEstimate gloam_issao_basic(const ShadedPoint& at) {
    return mean_of_taps(covering_taps(at), [&](const Tap& tap) {
        return at.height(tap) > at.kernel.bias
                   ? gloam_contribution_issao_basic(tap.offset, at.normal, at.kernel.radius)
                   : 0.0;
    });
}

}  // namespace gloam::reference
