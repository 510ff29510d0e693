// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <complex>

#include "reference/geometry_camera.hpp"

// What all methods share: weights by distance, means, kernels, layers; contributions that a depth decides.
namespace gloam::reference {

inline double gloam_sample_cosine(dvec3 offset, dvec3 normal) {
    return gloam_unit_interval(dot(gloam_safe_normalize(offset, dvec3(0.0)), normal));
}

inline double gloam_depth_bias(double bias, double depth, double reference_depth) {
    const bool known = bias > 0.0 && reference_depth >= float_min && reference_depth <= 0x1p126;
    return gloam_is_background(depth) || !known ? 0.0 : min(bias * depth / reference_depth, float_max);
}

// d / R inside the radius of influence; 1, which counts nothing, beyond it and for what is not a radius.
inline double falloff_ratio(double hit_distance, double radius) {
    const double d = abs(hit_distance);
    return d < radius && radius >= float_min ? d / radius : 1.0;
}

inline double gloam_falloff_linear(double hit_distance, double radius) {
    return 1.0 - falloff_ratio(hit_distance, radius);
}

inline double gloam_falloff_quadratic(double hit_distance, double radius) {
    return 1.0 - pow(falloff_ratio(hit_distance, radius), 2);
}

inline double gloam_falloff_step(double hit_distance, double radius) {
    return abs(hit_distance) <= radius ? 1.0 : 0.0;
}

inline double gloam_falloff_exponential(double hit_distance, double radius) {
    if (!is_finite(hit_distance) || !(radius >= float_min)) return 0.0;
    const double weight = exp(-abs(hit_distance) / radius);
    return weight >= 1.0 / 255.0 ? weight : 0.0;
}

inline double gloam_falloff_alchemy(double hit_distance, double u) {
    const double d = abs(hit_distance);
    return is_finite(d) && is_finite(u) && u >= float_min ? u * d / pow(max(u, d), 2) : 0.0;
}

// Step, linear, quadratic, cubic; any other number is linear.
inline double gloam_falloff_at(unsigned falloff, double x) {
    if (falloff == 0U) return x <= 1.0 ? 1.0 : 0.0;
    return max(1.0 - pow(x, falloff <= 3U ? falloff : 1U), 0.0);
}

inline dvec2 gloam_estimator_add(dvec2 accumulated, double contribution) {
    return is_finite(contribution) ? accumulated + dvec2(contribution, 1.0) : accumulated;
}

// Of (sum, weight), inside [0, 1].
inline double weighted_ratio(dvec2 weighted) {
    if (!(weighted.y >= float_min && weighted.x > 0.0)) return 0.0;
    return weighted.x < weighted.y ? weighted.x / weighted.y : 1.0;
}

inline double gloam_estimator_mean(dvec2 accumulated) {
    return accumulated.y >= 1.0 ? weighted_ratio(accumulated) : 0.0;
}

struct GloamKernel {
    double radius;
    double bias;
    double angle;
    unsigned first;
    unsigned count;
    double farthest;
};

struct GloamEstimate {
    double occlusion;
    double samples;
    double weight = 1.0;
};

inline bool gloam_can_gather(dvec3 position, dvec3 normal, double radius, const GloamCamera& camera) {
    const auto usable = [](double x) { return x >= 1e-18F && x <= 1e18F; };
    const bool placed = abs(position.x) <= 1e18F && abs(position.y) <= 1e18F && usable(-position.z);
    const bool projects = usable(abs(camera.p00_p11.x)) && usable(abs(camera.p00_p11.y));
    return placed && projects && length(normal) >= 1e-15 && length(normal) <= 1e15 && usable(radius) &&
           std::min(camera.size.x, camera.size.y) > 0;
}

inline GloamEstimate gloam_estimate(double occluded, double whole, unsigned samples) {
    return {weighted_ratio({occluded, whole}), static_cast<double>(samples)};
}

inline GloamEstimate gloam_slice_estimate(double occluded, double whole, unsigned slices, unsigned steps) {
    GloamEstimate estimate = gloam_estimate(occluded, whole, slices * 2U * steps);
    estimate.weight = whole / std::max(slices, 1U);
    return estimate;
}

inline bool gloam_tap_sees(double depth) {
    return depth >= 1e-18F && depth <= 1e18F;
}

inline bool gloam_tap_rejected(double depth, double tap_depth, double threshold) {
    return gloam_tap_sees(depth) && gloam_tap_sees(tap_depth) && depth - tap_depth > threshold;
}

inline double gloam_layer_depth(double first, dvec3 further, int layer) {
    return layer == 0 ? first : abs(further[std::min(layer, 3) - 1]);
}

struct GloamLayersSeen {
    double occlusion;
    double before;
    bool front;
};

// A back right behind a front closes that object: where it lies before the point, what its front blocked is
// taken back. The last of three or more layers closes nothing.
inline GloamLayersSeen gloam_layers_add(const GloamLayersSeen& seen, double blocked, dvec3 further,
                                        double depth, int layer, int layers) {
    if (layer == 0) return {blocked, 0.0, true};
    const double signed_depth = further[std::min(layer, 3) - 1];
    const bool back = seen.front && signed_depth < 0.0;
    const bool closes = back && (layers == 2 || layer < layers - 1) && -signed_depth < depth;
    const double left = closes ? seen.before : seen.occlusion;
    return {back ? left : max(left, blocked), left, signed_depth > 0.0};
}

inline bool gloam_sample_blocked(double sample_depth, double buffer_depth, double bias, double range) {
    const double in_front = sample_depth - buffer_depth;
    return gloam_tap_sees(buffer_depth) && in_front > bias && in_front <= range;
}

inline double gloam_contribution_crytek(double sample_depth, double buffer_depth) {
    return gloam_tap_sees(buffer_depth) && buffer_depth <= sample_depth ? 1.0 : 0.0;
}

inline double gloam_contribution_crytek_buffer(double sample_value, double buffer_value) {
    return buffer_value < 1.0 && buffer_value <= sample_value ? 1.0 : 0.0;
}

inline dvec3 gloam_crytek_sample(dvec2 uv, double buffer_value, dvec3 s, double radius, double depth,
                                 double z_far) {
    const dvec3 center(uv, buffer_value);
    if (gloam_is_background(depth) || !(z_far >= 1e-30 && z_far <= 0x1p126)) return center;
    return center + radius / depth * s * dvec3(1.0, 1.0, 100.0 / z_far * buffer_value);
}

inline double gloam_contribution_filion(double sample_depth, double buffer_depth, double radius) {
    const double in_front = sample_depth - buffer_depth;
    if (!(gloam_tap_sees(buffer_depth) && in_front > 0.0)) return 0.0;
    return 1.0 - max((in_front - radius) / in_front, 0.0);
}

inline double gloam_contribution_ritschel(double blocked, double falloff, double cosine) {
    return gloam_unit_interval(blocked) * gloam_unit_interval(falloff) * gloam_unit_interval(cosine);
}

inline double gloam_contribution_uniform_directions(double blocked, double falloff, double cosine) {
    return 2.0 * gloam_contribution_ritschel(blocked, falloff, cosine);
}

inline double gloam_occlusion_bowl(double a, double b) {
    return gloam_unit_interval(1.0 - (1.0 / sqrt(std::complex(1.0, a) * std::complex(1.0, b))).real());
}

inline double gloam_occlusion_saddle(double a, double b) {
    const std::complex<double> x(1.0, a);
    const std::complex<double> y(1.0, b);
    const double t = sqrt(-a / b);
    return gloam_unit_interval(2.0 / pi * (atan(t) - (atan(t * sqrt(y / x)) / sqrt(x * y)).real()));
}

inline double gloam_occlusion_curvature(double k_1, double k_2, double radius) {
    if (!(radius > 0.0) || std::isnan(k_1) || std::isnan(k_2)) return 0.0;
    const double a = radius / 2.0 * max(k_1, k_2);
    const double b = radius / 2.0 * min(k_1, k_2);
    if (!(a > 0.0) || std::isnan(b)) return 0.0;
    const auto occlusion = b >= -1e-4 ? gloam_occlusion_bowl : gloam_occlusion_saddle;
    return occlusion(std::clamp(a, -4096.0, 4096.0), std::clamp(b, -4096.0, 4096.0));
}

}  // namespace gloam::reference
