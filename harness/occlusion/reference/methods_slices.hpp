// SPDX-License-Identifier: MIT
#pragma once

#include "reference/methods_points.hpp"

// Methods of slices: horizons, sectors and sweeps.
namespace gloam::reference {

// Sum of all slices of a kernel.
struct SliceSum {
    dvec2 sum{0.0};  // (occluded, whole)
    unsigned slices = 0U;
};

// One slice: tap i to the side 1 or -1 at place((i + jitter) / steps) of the radius.
struct SliceTaps {
    const ShadedPoint& at;
    GloamSlice slice;
    GloamSliceSample sample;
    unsigned steps;
    const std::function<double(double)>& place;

    [[nodiscard]] Tap tap(double side, unsigned i) const {
        return at.tap(at.under(side * place((i + sample.jitter) / steps) * sample.direction));
    }
    // Whether what the tap sees may block.
    [[nodiscard]] bool contributes(const Tap& tap) const {
        return tap.surface && tap.pixel != at.pixel && !tap.rejected;
    }
    [[nodiscard]] bool counts(const Tap& tap) const {
        return contributes(tap) && at.height(tap) > at.kernel.bias;
    }
    // Its offset, moved into the slice along the tangent plane: (along view, along tangent).
    [[nodiscard]] dvec2 within(const Tap& tap) const {
        const dvec3 offset = gloam_into_slice(tap.offset, cross(slice.tangent, slice.view), at.normal);
        return {dot(offset, slice.view), dot(offset, slice.tangent)};
    }
};

// The sum of add(slice) = (occluded, whole) over the slices of a kernel.
template <class Add>
SliceSum sum_of_slices(const ShadedPoint& at, unsigned steps, dvec3 view,
                       const std::function<double(double)>& place, const Add& add) {
    SliceSum all{.slices = gloam_whole_samples(at.kernel.count, 2U * steps) / (2U * steps)};
    for (unsigned s = 1; s <= all.slices; ++s) {
        const GloamSliceSample sample =
            gloam_slice_sample(at.kernel.first / (2U * steps) + s, gloam_turns(at.kernel.angle));
        const GloamSlice slice = gloam_slice(sample.direction * at.upright, view, at.normal);
        all.sum += add(SliceTaps{at, slice, sample, steps, place});
    }
    return all;
}
inline double squared_place(double share) {
    return share * share;
}

struct GloamGtao {
    unsigned steps;
};
// Slice by slice the highest horizon on either side.
inline GloamEstimate gloam_gtao(const ShadedPoint& at, const GloamGtao& own) {
    const unsigned steps = std::max(own.steps, 1U);
    const SliceSum all = sum_of_slices(at, steps, at.view, squared_place, [&](const SliceTaps& taps) {
        const GloamSlice& slice = taps.slice;
        const auto horizon = [&](double side) {
            const double lowest = -side * slice.normal.y;
            double highest = lowest;
            for (unsigned i = 0; i < steps; ++i) {
                const Tap tap = taps.tap(side, i);
                if (taps.counts(tap))
                    highest = gloam_gtao_horizon(highest, lowest, taps.within(tap), at.kernel.radius);
            }
            return highest;
        };
        const double occluded =
            gloam_gtao_side(horizon(-1.0), -slice.angle, {slice.normal.x, -slice.normal.y}) +
            gloam_gtao_side(horizon(1.0), slice.angle, slice.normal);
        return slice.weight * dvec2(occluded, gloam_slice_whole(slice));
    });
    return gloam_slice_estimate(all.sum.x, all.sum.y, all.slices, steps);
}

struct GloamSweep {
    unsigned steps;
    double feature_thickness;
    unsigned falloff;
};
// Slice by slice the directions that each tap uncovers on either side, with the falloff at their distance.
// What lies behind a horizon is I(H) - I(h), calculated anew for each tap.
inline GloamEstimate gloam_sweep(const ShadedPoint& at, const GloamSweep& own) {
    const unsigned steps = std::max(own.steps, 1U);
    const double thickness = own.feature_thickness > 0.0 ? std::min(own.feature_thickness, 1e18) : 0.0;
    const dvec2 reach = at.axes * dvec2(at.camera.size);
    const auto place = [&](double share) { return gloam_slice_place(share, max(reach.x, reach.y)); };
    const SliceSum all = sum_of_slices(at, steps, at.view, place, [&](const SliceTaps& taps) {
        if (!(taps.slice.weight > 0.0)) return dvec2(0.0);
        double occluded = 0.0;
        for (const double towards : {1.0, -1.0}) {
            const GloamSlice half_plane = gloam_sweep_slice(taps.slice, towards);
            GloamSweepSide side = gloam_sweep_side(-half_plane.normal.y);
            for (unsigned i = 0; i < steps; ++i) {
                const Tap tap = taps.tap(towards, i);
                const dvec2 within = taps.within(tap) * dvec2(1.0, towards) / at.kernel.radius;
                const double sine = sqrt(max(1.0 - side.horizon * side.horizon, 0.0));
                side.behind = gloam_sweep_behind({side.horizon, sine}, half_plane);
                side = gloam_sweep_tap(side, half_plane, within, taps.contributes(tap), taps.counts(tap),
                                       own.falloff, thickness);
            }
            occluded += side.occluded + side.feature;
        }
        return taps.slice.weight * dvec2(occluded, gloam_slice_whole(taps.slice));
    });
    return gloam_slice_estimate(all.sum.x, all.sum.y, all.slices, steps);
}

struct GloamBitmask {
    double thickness;
    unsigned steps;
};
// The share of 32 directions, evenly spread by the cosine, that lie between the front and the back of a tap.
inline GloamEstimate gloam_bitmask(const ShadedPoint& at, const GloamBitmask& own) {
    const unsigned steps = std::max(own.steps, 1U);
    const double thickness = own.thickness > 0.0 && own.thickness <= 1e18 ? own.thickness : 0.0;
    const SliceSum all = sum_of_slices(at, steps, at.view, squared_place, [&](const SliceTaps& taps) {
        std::vector<dvec2> covered;
        for (unsigned i = 0; i < 2U * steps; ++i) {
            const Tap tap = taps.tap(i < steps ? 1.0 : -1.0, i % steps);
            const dvec2 front = taps.within(tap);
            if (!taps.counts(tap) || !(length(front) < taps.sample.share * at.kernel.radius)) continue;
            const auto fraction = [&](dvec2 end) {
                const double far = length(end);
                return gloam_slice_fraction_cosine(far > 0.0 ? end / far : end, taps.slice);
            };
            const double first = fraction(front);
            const double second = fraction(front - dvec2(thickness, 0.0));
            covered.emplace_back(min(first, second), max(first, second));
        }
        double sectors = 0.0;
        for (int i = 0; i < 32; ++i)
            sectors += std::ranges::any_of(
                covered, [&](dvec2 part) { return part.x <= (i + 0.5) / 32.0 && (i + 0.5) / 32.0 < part.y; });
        return taps.slice.weight * gloam_slice_whole(taps.slice) * dvec2(sectors / 32.0, 1.0);
    });
    return gloam_slice_estimate(all.sum.x, all.sum.y, all.slices, steps);
}

// What a march finds that begins at a horizon of that sine: the highest horizon of its first k surfaces, less
// that of the first k - 1, by the falloff at surface k. surfaces: (rise, distance).
inline double uncovered(double start, const std::vector<dvec2>& surfaces, double radius) {
    const auto sine = [](dvec2 surface) { return min(surface.x / surface.y, 1.0); };
    double found = 0.0;
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
        double before = start;
        for (std::size_t i = 0; i < k; ++i)
            if (surfaces[i].y <= radius) before = max(before, sine(surfaces[i]));
        const double share = surfaces[k].y / radius;
        if (share <= 1.0) found += (1.0 - share * share) * max(sine(surfaces[k]) - before, 0.0);
    }
    return found;
}

// Mean visibility lost over slices along the image; start(direction): sine at which a side's horizon begins;
// surfaces of a tap: its own, or those of all layers.
template <class Place, class Start, class Seen>
GloamEstimate horizons(const ShadedPoint& at, unsigned steps, const Place& place, const Start& start,
                       const Seen& seen, double angle_bias, double contrast) {
    const SliceSum all = sum_of_slices(at, steps, {0.0, 0.0, 1.0}, place, [&](const SliceTaps& taps) {
        double occlusion = 0.0;
        for (const double side : {1.0, -1.0}) {
            std::vector<dvec2> surfaces;
            for (unsigned i = 0; i < steps; ++i)
                for (const Tap& tap : seen(taps.tap(side, i))) {
                    const dvec2 within = taps.within(tap);
                    if (taps.counts(tap)) surfaces.emplace_back(within.x, length(within));
                }
            const dvec2 direction = side * taps.sample.direction * at.upright;
            occlusion += uncovered(start(direction), surfaces, at.kernel.radius);
        }
        return dvec2(1.0 - gloam_hbao_visibility(occlusion / 2.0, angle_bias, contrast), 0.0);
    });
    return gloam_estimate(all.sum.x, all.slices, all.slices * 2U * steps);
}

// Of hbao, hbao_study and hsao.
struct GloamHbao {
    double angle_bias;
    double contrast;
    unsigned steps;
};
inline double hbao_start(const ShadedPoint& at, dvec2 direction, double angle_bias) {
    return gloam_hbao_horizon(at.normal, direction, on_circle(angle_bias)).y;
}
inline GloamEstimate gloam_hbao(const ShadedPoint& at, const GloamHbao& own) {
    return horizons(
        at, std::max(own.steps, 1U), squared_place,
        [&](dvec2 direction) { return hbao_start(at, direction, own.angle_bias); },
        [](const Tap& tap) { return std::vector{tap}; }, own.angle_bias, own.contrast);
}

inline GloamEstimate gloam_hbao_study(const ShadedPoint& at, const GloamHbao& own) {
    return horizons(
        at, std::max(own.steps, 1U), [](double share) { return share; },
        [&](dvec2 direction) {
            return gloam_hbao_start_slope(gloam_tangent_slope(at.normal, direction), own.angle_bias).x;
        },
        [](const Tap& tap) { return std::vector{tap}; }, 0.0, own.contrast);
}

// hbao with marches in eye space: rays parallel to the image, each a side of a slice.
inline GloamEstimate gloam_hsao(const ShadedPoint& at, const GloamHbao& own) {
    const unsigned steps = std::max(own.steps, 1U);
    GloamEstimate estimate = mean_of_rays(at.kernel, steps, [&](unsigned i) {
        const ImageRay ray = image_ray(at, i, steps);
        const dvec3 axis(ray.direction.y, -ray.direction.x, 0.0);
        std::vector<dvec2> surfaces;
        for (const Tap& tap : ray.taps) {
            const dvec3 within = gloam_into_slice(tap.offset, axis, at.normal);
            if (tap.surface && at.height(tap) > at.kernel.bias)
                surfaces.emplace_back(within.z, length(within));
        }
        return uncovered(hbao_start(at, ray.direction, own.angle_bias), surfaces, at.kernel.radius);
    });
    estimate.occlusion = 1.0 - gloam_hbao_visibility(estimate.occlusion, own.angle_bias, own.contrast);
    return estimate;
}

struct GloamSeparable {
    double sigma;
};
// A slice of gtao in one of two directions, and the mean of the first ones along the second's line.
inline GloamEstimate gloam_separable(const ShadedPoint& at, const GloamSeparable& own) {
    const unsigned steps = std::max(at.kernel.count / 4U, 1U);
    GloamKernel second = at.kernel;
    second.angle += pi;
    second.count = 2U * steps;
    second.first = at.kernel.first / (2U * second.count) * second.count;
    GloamKernel line = at.kernel;
    line.radius = 2.0 * max(own.sigma, 0.0);
    const dvec2 direction =
        gloam_slice_sample(second.first / second.count + 1U, gloam_turns(second.angle)).direction;
    const dvec2 axes = gloam_camera_radius(line.radius, -at.position.z, at.camera);
    dvec2 sum(0.0);
    const auto add = [&](glm::ivec2 pixel, double weight) {
        const double first = at.images.prepared(pixel).x;
        if (first >= 0.0 && first <= 1.0) sum += weight * dvec2(first, 1.0);
    };
    add(at.pixel, 1.0);
    for (unsigned i = 0; i < 2U * steps; ++i) {
        const double share = (i / 2U + 1.0) / steps * (i % 2U == 0U ? 1.0 : -1.0);
        const Tap tap = at.tap(gloam_nearest_pixel(at.uv + share * axes * direction, at.camera.size));
        if (tap.surface && tap.pixel != at.pixel)
            add(tap.pixel, gloam_separable_weight(tap.offset, at.normal, own.sigma, 0.1 * own.sigma));
    }
    const double first = sum.y > 0.0 ? sum.x / sum.y : gloam_unit_interval(at.images.prepared(at.pixel).x);
    return {gloam_separable_mean(first, gloam_gtao(at.with(second), {steps}).occlusion),
            static_cast<double>(gloam_whole_samples(at.kernel.count, 4U))};
}

}  // namespace gloam::reference
