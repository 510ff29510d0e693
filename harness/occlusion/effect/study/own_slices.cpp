// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <bitset>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "effect/internal/own_integrands.hpp"
#include "effect/study/angles.hpp"

namespace gloam::effect::own {
namespace {

using std::numbers::pi;

// A slice along the image plane's direction (cos a, sin a). The eye is on the axis, so the slice contains the
// z axis.
struct Slice {
    glm::dvec3 along{1, 0, 0};  // unit, in the image plane
    double normal_angle = 0.0;  // angle of the projected normal from the axis, towards `along`
    double weight = 0.0;        // length of the projected normal
};

Slice slice_at(const SeenSurface& seen, double angle) {
    Slice slice{.along = {std::cos(angle), std::sin(angle), 0.0}};
    const double x = glm::dot(seen.normal(), slice.along);
    slice.normal_angle = std::atan2(x, seen.normal().z);
    slice.weight = std::hypot(x, seen.normal().z);
    return slice;
}

// A sample within the slice: its distance along the slice and towards the eye.
struct Step {
    double along = 0.0;
    double up = 0.0;
    bool rises = true;  // above the tangent plane, by more than the bias

    [[nodiscard]] double length() const { return std::hypot(along, up); }
    [[nodiscard]] double angle() const { return std::atan2(along, up); }  // from the axis
};

// How the steps of a slice lie: evenly, by squares, or as gloam_slice_place has them.
enum class Places { even, squared, mixed };

// The samples of one side (+1 or -1). A surface seen beside the slice is moved into it without changing its
// height over the tangent plane.
std::vector<Step> taps_of(const SeenSurface& seen, const Settings& settings, const Slice& slice, double side,
                          double jitter, Places places) {
    const glm::dvec3& n = seen.normal();
    const glm::dvec3 aside = glm::cross(slice.along, glm::dvec3(0, 0, 1));
    const double turned = glm::dot(aside, n);
    const glm::dvec3 across = (aside - turned * n) / (1.0 - turned * turned);
    const double own = std::min(1.3 * seen.pitch() / seen.reach(), 1.0);
    std::vector<Step> found;
    for (std::uint32_t i = 0; i < settings.own.steps; ++i) {
        const double share = (i + jitter) / settings.own.steps;
        const double place = places == Places::even      ? share
                             : places == Places::squared ? share * share
                                                         : own + (1.0 - own) * share * (0.4 + 0.6 * share);
        const Seen surface = seen.at(side * place * seen.reach() * glm::dvec2(slice.along));
        if (surface.background || surface.own_pixel) continue;
        const glm::dvec3 offset = surface.offset - glm::dot(surface.offset, aside) * across;
        found.push_back(
            {glm::dot(offset, slice.along), offset.z, glm::dot(surface.offset, n) > double{settings.bias}});
    }
    return found;
}

// The samples that rise above the tangent plane by more than the bias.
std::vector<Step> steps_of(const SeenSurface& seen, const Settings& settings, const Slice& slice, double side,
                           double jitter, Places places = Places::squared) {
    std::vector<Step> found = taps_of(seen, settings, slice, side, jitter, places);
    std::erase_if(found, [](const Step& step) { return !step.rises; });
    return found;
}

// Integral of |sin t| cos(t - n) over t from a to b, both on the same side of 0: the cosine-weighted share of
// a slice.
double cosine_arc(double a, double b, double n) {
    const auto antiderivative = [n](double t) {
        return -0.25 * std::cos(2.0 * t - n) + 0.5 * t * std::sin(n);
    };
    const double integral = antiderivative(b) - antiderivative(a);
    return a + b < 0.0 ? -integral : integral;
}

// The same integral over the part of the half plane around n between a and b.
double cosine_measure(double a, double b, double n) {
    const double low = std::max(a, n - right_angle);
    const double high = std::min(b, n + right_angle);
    if (!(low < high)) return 0.0;
    return cosine_arc(low, std::clamp(0.0, low, high), n) + cosine_arc(std::clamp(0.0, low, high), high, n);
}

double cosine_whole(double n) {
    return cosine_measure(n - right_angle, n + right_angle, n);
}

// HBAO's sum over one side: each increase of the horizon's sine, weighted by 1 - |v|^2. start: first
// elevation.
double hbao_side(const std::vector<Step>& steps, double start) {
    double horizon = std::sin(start);
    double occlusion = 0.0;
    for (const Step& step : steps) {
        const double squared = step.length() * step.length();
        const double sine = step.up / step.length();
        if (!(squared < 1.0 && sine > horizon)) continue;
        occlusion += (sine - horizon) * (1.0 - squared);
        horizon = sine;
    }
    return occlusion;
}

// GTAO's horizon as a cosine from the axis. The linear falloff moves each sample towards the tangent plane.
double gtao_horizon(const std::vector<Step>& steps, double lowest) {
    double horizon = -1.0;
    for (const Step& step : steps) {
        const double weight = std::max(1.0 - step.length(), 0.0);
        if (weight > 0.0) horizon = std::max(horizon, lowest + weight * (step.up / step.length() - lowest));
    }
    return horizon;
}

// The part of one side that a sweep counts as blocked. Each tap blocks from its angle to the lowest angle of
// the taps before, with the linear falloff at the mean of its distance and the previous tap's. The previous
// distance is at most the radius. A feature that ends counts by its width times `thickness`, over its rise.
double sweep_side(const std::vector<Step>& taps, double side, double n, double thickness) {
    double lowest = n + side * right_angle;
    double occluded = 0.0;
    Step last{};
    struct Feature {
        double amount;
        double rise;
        double start;
    };
    std::optional<Feature> feature;
    for (const Step& tap : taps) {
        if (feature && tap.up < last.up - 0.8 * feature->rise) {
            const double width = 0.5 * std::abs(tap.along + last.along) - feature->start;
            occluded += feature->amount * std::min(1.0, thickness * width / feature->rise);
            feature.reset();
        }
        const double weight = 1.0 - 0.5 * (std::min(last.length(), 1.0) + tap.length());
        const double angle = side * std::abs(tap.angle());
        if (tap.rises && weight > 0.0 && std::abs(angle) < side * lowest) {
            if (!feature)
                feature = {0.0, std::max(tap.up - last.up, 1e-4), 0.5 * std::abs(tap.along + last.along)};
            feature->amount += weight * cosine_measure(std::min(angle, lowest), std::max(angle, lowest), n);
            lowest = angle;
        }
        last = tap;
    }
    return occluded + (feature ? feature->amount : 0.0);
}

constexpr std::size_t sectors = 32;

// Marks the sectors of equal cosine-weighted share whose centre is in [low, high): this is the centre rule.
void cover(std::bitset<sectors>& covered, double low, double high) {
    for (std::size_t i = 0; i < sectors; ++i) {
        const double center = (static_cast<double>(i) + 0.5) / sectors;
        if (low <= center && center < high) covered.set(i);
    }
}

// Share of the half plane below an angle. An angle of [-pi, pi] behind the half plane is moved to its nearer
// end.
double share_below(double angle, double n) {
    return cosine_measure(n - right_angle, std::max(angle, n - right_angle), n) / cosine_whole(n);
}

}  // namespace

// CS-3.4: horizons over the image plane; the sum is divided by 1 - sin(bias) to compensate the bias.
Integrand hbao(const SeenSurface& seen, const Settings& s) {
    return [seen, s](const std::array<double, 3>& u) {
        const Slice slice = slice_at(seen, pi * u[0]);
        const double bias = double{s.own.angle_bias};
        const double slope = -glm::dot(glm::dvec2(seen.normal()), glm::dvec2(slice.along));
        double occlusion = 0.0;
        for (const double side : {1.0, -1.0}) {
            const double tangent = std::atan2(side * slope, seen.normal().z);
            const double start = std::min(tangent + bias, right_angle);
            occlusion += 0.5 * hbao_side(steps_of(seen, s, slice, side, u[1]), start);
        }
        return glm::dvec2(std::min(double{s.own.intensity} * occlusion / (1.0 - std::sin(bias)), 1.0), 1.0);
    };
}

// CS-C as the study prints it: the tangents are added at the start, steps are even, the bias is not
// compensated.
Integrand hbao_study(const SeenSurface& seen, const Settings& s) {
    return [seen, s](const std::array<double, 3>& u) {
        const Slice slice = slice_at(seen, pi * u[0]);
        const double slope = -glm::dot(glm::dvec2(seen.normal()), glm::dvec2(slice.along));
        double occlusion = 0.0;
        for (const double side : {1.0, -1.0}) {
            const double start =
                std::atan(side * slope / seen.normal().z + std::tan(double{s.own.angle_bias}));
            occlusion += 0.5 * hbao_side(steps_of(seen, s, slice, side, u[1], Places::even), start);
        }
        return glm::dvec2(std::min(double{s.own.intensity} * occlusion, 1.0), 1.0);
    };
}

// Jimenez et al. 2016: each slice is weighted by the measure of its half plane.
Integrand gtao(const SeenSurface& seen, const Settings& s) {
    return [seen, s](const std::array<double, 3>& u) {
        const Slice slice = slice_at(seen, pi * u[0]);
        const double n = slice.normal_angle;
        const double right = gtao_horizon(steps_of(seen, s, slice, 1.0, u[1]), std::cos(n + right_angle));
        const double left = gtao_horizon(steps_of(seen, s, slice, -1.0, u[1]), std::cos(n - right_angle));
        const double occluded =
            cosine_measure(std::acos(right), pi, n) + cosine_measure(-pi, -std::acos(left), n);
        return slice.weight * glm::dvec2(occluded, cosine_whole(n));
    };
}

// Sweep: each direction has the falloff at its distance.
Integrand sweep(const SeenSurface& seen, const Settings& s) {
    return [seen, s](const std::array<double, 3>& u) {
        const Slice slice = slice_at(seen, pi * u[0]);
        double occluded = 0.0;
        for (const double side : {1.0, -1.0})
            occluded += sweep_side(taps_of(seen, s, slice, side, u[1], Places::mixed), side,
                                   slice.normal_angle, double{s.own.feature_thickness});
        return slice.weight * glm::dvec2(occluded, cosine_whole(slice.normal_angle));
    };
}

// Therrien et al. 2023: the sectors between the front and the back of each sample nearer than a random
// distance.
Integrand bitmask(const SeenSurface& seen, const Settings& s) {
    return [seen, s](const std::array<double, 3>& u) {
        const Slice slice = slice_at(seen, pi * u[0]);
        const double n = slice.normal_angle;
        std::bitset<sectors> covered;
        for (const double side : {1.0, -1.0}) {
            for (const Step& step : steps_of(seen, s, slice, side, u[1])) {
                if (!(step.length() < u[2])) continue;
                const double front = step.angle();
                const double back = Step{step.along, step.up - double{s.own.thickness}}.angle();
                cover(covered, share_below(std::min(front, back), n), share_below(std::max(front, back), n));
            }
        }
        const double share = static_cast<double>(covered.count()) / sectors;
        return slice.weight * cosine_whole(n) * glm::dvec2(share, 1.0);
    };
}

}  // namespace gloam::effect::own
