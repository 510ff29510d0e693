// SPDX-License-Identifier: MIT
#pragma once

#include "reference/shaded_point.hpp"

// Methods that ask whether points of a ball, or of rays, are blocked.
namespace gloam::reference {

// Mean of blocked(depth on the plane through the point, pixel) over points p + R s, s in the surface's frame.
// A point behind the eye, or whose pixel is rejected, is not taken.
template <class Blocked>
GloamEstimate mean_of_points(const ShadedPoint& at, const std::vector<dvec3>& points,
                             const Blocked& blocked) {
    double sum = 0.0;
    unsigned samples = 0U;
    for (const dvec3 s : points) {
        const dvec3 turned = gloam_tangent_frame(at.normal) * gloam_rotate_hemisphere(s, at.kernel.angle);
        const dvec3 point = at.position + at.kernel.radius * turned;
        if (s == dvec3(0.0) || !(point.z < 0.0)) continue;
        const glm::ivec2 pixel = at.under(point);
        if (at.tap(pixel).rejected) continue;
        sum += blocked(at.plane_depth(pixel, point), pixel);
        ++samples;
    }
    return gloam_estimate(sum, samples, samples);
}

template <class Point>
std::vector<dvec3> kernel_points(const GloamKernel& kernel, const Point& point) {
    std::vector<dvec3> points;
    for (unsigned i = 1; i <= kernel.count; ++i) points.push_back(point(kernel.first + i));
    return points;
}

// Whether the layers at a pixel block a point of that depth there.
inline double blocked_by_layers(const ShadedPoint& at, glm::ivec2 pixel, double depth, double range,
                                int layers) {
    const dvec3 further = at.further(pixel, layers);
    GloamLayersSeen seen{};
    for (int layer = 0; layer < layers; ++layer) {
        const bool blocked = gloam_sample_blocked(depth, at.depth(pixel, layer), at.kernel.bias, range);
        seen = gloam_layers_add(seen, blocked ? 1.0 : 0.0, further, depth, layer, layers);
    }
    return seen.occlusion;
}

struct GloamHemisphere {
    double range;
    int layers;
};
inline GloamEstimate gloam_hemisphere(const ShadedPoint& at, const GloamHemisphere& own) {
    const auto cosine = [](unsigned i) { return gloam_hemisphere_cosine(gloam_halton_3d(i)); };
    return mean_of_points(at, kernel_points(at.kernel, cosine), [&](double depth, glm::ivec2 pixel) {
        return blocked_by_layers(at, pixel, depth, own.range, own.layers);
    });
}

inline GloamEstimate gloam_filion(const ShadedPoint& at) {
    const auto uniform = [](unsigned i) { return gloam_hemisphere_uniform(gloam_halton_3d(i)); };
    return mean_of_points(at, kernel_points(at.kernel, uniform), [&](double depth, glm::ivec2 pixel) {
        return gloam_contribution_filion(depth - at.kernel.bias, at.images.depth(pixel), at.kernel.radius);
    });
}

// Odd numbers of the sequence are points of the half ball, even ones the points opposite to them.
inline GloamEstimate gloam_crytek(const ShadedPoint& at) {
    const auto opposite = [](unsigned i) {
        return (i % 2U == 0U ? -1.0 : 1.0) * gloam_hemisphere_uniform(gloam_halton_3d((i + 1U) / 2U));
    };
    return mean_of_points(at, kernel_points(at.kernel, opposite), [&](double depth, glm::ivec2 pixel) {
        return gloam_contribution_crytek(depth - at.kernel.bias, at.images.depth(pixel));
    });
}

// What the steps of a ray see: pixels before the eye but the point's own, with the place of each step.
struct RayStep {
    dvec3 point;
    glm::ivec2 pixel;
};
inline std::vector<RayStep> ray_steps(const ShadedPoint& at, dvec3 direction, unsigned steps, double jitter) {
    std::vector<RayStep> seen;
    for (unsigned k = 0; k < steps; ++k) {
        const dvec3 point = gloam_eye_march(at.position, direction, at.kernel.radius, k, steps, jitter);
        const glm::ivec2 pixel = at.under(point);
        if (point.z < 0.0 && pixel != at.pixel) seen.push_back({point, pixel});
    }
    return seen;
}

// Sum of occluded(index of the ray) over the rays of a kernel, each of that many steps, as an estimate.
template <class Occluded>
GloamEstimate mean_of_rays(const GloamKernel& kernel, unsigned steps, const Occluded& occluded) {
    const unsigned samples = gloam_whole_samples(kernel.count, steps);
    double sum = 0.0;
    for (unsigned i = 0; i < samples / steps; ++i) sum += occluded(kernel.first / steps + i);
    return gloam_estimate(sum, samples / steps, samples);
}

struct GloamPoisson {
    double range;
    unsigned steps;
};
// The share of the rays of which a step is blocked; each round through the disc is turned by another angle.
inline GloamEstimate gloam_poisson(const ShadedPoint& at, const GloamPoisson& own) {
    const unsigned steps = std::max(own.steps, 1U);
    return mean_of_rays(at.kernel, steps, [&](unsigned i) {
        const double turn = at.kernel.angle + 2.0 * pi * gloam_radical_inverse(i / 64U, 2U);
        const dvec3 lifted = gloam_hemisphere_lift(gloam_rotate_disc(gloam_poisson_disc(i), turn));
        const double shift = gloam_unit_interval(at.kernel.angle / (2.0 * pi));
        const double jitter = fract(gloam_halton_3d(i + 1U).y + shift);
        const auto steps_seen = ray_steps(at, gloam_tangent_frame(at.normal) * lifted, steps, jitter);
        return std::ranges::any_of(steps_seen, [&](const RayStep& step) {
            return gloam_sample_blocked(at.plane_depth(step.pixel, step.point), at.images.depth(step.pixel),
                                        at.kernel.bias, own.range);
        });
    });
}

struct GloamSsdo {
    double range;
    unsigned steps;
    int layers;
};
// Light of the same radiance from all directions, cosine-weighted: what blocked rays would have brought.
inline GloamEstimate gloam_ssdo(const ShadedPoint& at, const GloamSsdo& own) {
    const unsigned steps = std::max(own.steps, 1U);
    return mean_of_rays(at.kernel, steps, [&](unsigned i) {
        const dvec3 random = gloam_halton_3d(i + 1U);
        const dvec3 unit = gloam_hemisphere_uniform({random.x, 1.0, random.z});
        const dvec3 turned = gloam_rotate_hemisphere(unit, at.kernel.angle);
        bool blocked = false;
        for (const RayStep& step : ray_steps(at, gloam_tangent_frame(at.normal) * turned, steps, random.y))
            for (int layer = 0; layer < own.layers; ++layer)
                blocked =
                    blocked || gloam_sample_blocked(at.plane_depth(step.pixel, step.point),
                                                    at.depth(step.pixel, layer), at.kernel.bias, own.range);
        return blocked ? 2.0 * turned.z : 0.0;
    });
}

// A ray parallel to the image, and what its steps see; rays 2 k and 2 k + 1 are opposite.
struct ImageRay {
    dvec2 direction;
    std::vector<Tap> taps;
};
inline ImageRay image_ray(const ShadedPoint& at, unsigned index, unsigned steps) {
    const GloamSliceSample sample = gloam_slice_sample(index / 2U + 1U, gloam_turns(at.kernel.angle));
    ImageRay ray{(index % 2U == 1U ? -1.0 : 1.0) * sample.direction, {}};
    for (const RayStep& step : ray_steps(at, dvec3(ray.direction, 0.0), steps, sample.jitter))
        ray.taps.push_back(at.tap(step.pixel));
    return ray;
}

struct GloamUnreal {
    double epsilon;
    double intensity;
    unsigned steps;
};
// Of each ray along the image the step that blocks most.
inline GloamEstimate gloam_unreal(const ShadedPoint& at, const GloamUnreal& own) {
    const unsigned steps = std::max(own.steps, 1U);
    GloamEstimate estimate = mean_of_rays(at.kernel, steps, [&](unsigned i) {
        double most = 0.0;
        for (const Tap& tap : image_ray(at, i, steps).taps)
            if (tap.surface)
                most =
                    max(most, gloam_contribution_unreal(tap.offset, at.normal, at.kernel.bias, own.epsilon));
        return 1.0 - gloam_unreal_side(most);
    });
    estimate.occlusion = own.intensity > 0.0 ? min(own.intensity, 1.0) * estimate.occlusion : 0.0;
    return estimate;
}

}  // namespace gloam::reference
