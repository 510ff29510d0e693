// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "reference/occlusion.hpp"

// Blurs that stop at edges, and changes of resolution.
namespace gloam::reference {

struct GloamWeightedMean {
    double sum;
    double weight;
    double low;
    double high;
};

inline GloamWeightedMean gloam_weighted_mean_empty() {
    return {0.0, 0.0, 1.0, 0.0};
}

inline GloamWeightedMean gloam_weighted_mean_add(const GloamWeightedMean& mean, double value, double weight) {
    if (!(value >= 0.0 && value <= 1.0 && weight > 0.0 && is_finite(weight))) return mean;
    return {mean.sum + weight * value, mean.weight + weight, min(mean.low, value), max(mean.high, value)};
}

inline double gloam_weighted_mean_value(const GloamWeightedMean& mean, double fallback) {
    if (mean.weight >= 1e-8) return clamp(mean.sum / mean.weight, mean.low, mean.high);
    return gloam_unit_interval(fallback);
}

inline double gloam_gaussian_scale(double sigma) {
    if (std::isnan(sigma)) return infinity;
    return sigma <= 0x1p100 ? sqrt(std::numbers::log2e / 2.0) / max(sigma, float_min) : 0.0;
}

inline double gloam_gaussian_scaled(double squared_distance, double scale) {
    const double x = abs(squared_distance) * scale * scale;
    return x <= 99.5 ? exp2(-x) : 0.0;
}

inline double gloam_gaussian(double squared_distance, double sigma) {
    if (!is_finite(squared_distance) || std::isnan(sigma)) return 0.0;
    const double weight = exp(-abs(squared_distance) / (2.0 * pow(max(sigma, float_min), 2)));
    return weight >= 1e-30 ? weight : 0.0;
}

inline double gloam_filter_sigma(double depth, double tan_half_fovy, double height, double sigma_pixels) {
    const bool known = tan_half_fovy > 0.0 && height >= float_min && sigma_pixels > 0.0;
    if (gloam_is_background(depth) || !known) return 0.0;
    const double sigma = sigma_pixels * 2.0 * depth * tan_half_fovy / height;
    return std::isnan(sigma) ? 0.0 : min(sigma, float_max);
}

inline double gloam_bilateral_weight(dvec2 offset, double depth_difference, double sigma_d, double sigma_r) {
    const double weight =
        gloam_gaussian(dot(offset, offset), sigma_d) * gloam_gaussian(pow(depth_difference, 2), sigma_r);
    return weight >= 1e-30 ? weight : 0.0;
}

// The sum over every pixel of the image that lies in the window.
inline double gloam_bilateral_filter(glm::ivec2 pixel, glm::ivec2 half_width, glm::ivec2 size, double sigma_d,
                                     double sigma_r, const Fetch<double>& fetch_occlusion,
                                     const Fetch<double>& fetch_depth) {
    const double center = fetch_depth(pixel);
    const glm::ivec2 reach = clamp(half_width, 0, 16);
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    for (int i = 0; i < size.x * size.y && !gloam_is_background(center); ++i) {
        const glm::ivec2 tap(i % size.x, i / size.x);
        if (glm::abs(tap - pixel) != min(glm::abs(tap - pixel), reach)) continue;
        if (gloam_is_background(fetch_depth(tap))) continue;
        const double apart = fetch_depth(tap) - center;
        mean = gloam_weighted_mean_add(mean, fetch_occlusion(tap),
                                       gloam_bilateral_weight(tap - pixel, apart, sigma_d, sigma_r));
    }
    return gloam_weighted_mean_value(mean, fetch_occlusion(pixel));
}

inline double gloam_geometry_weight(dvec3 normal, dvec3 other, double depth_difference, double normal_power,
                                    double position_power) {
    const double facing = min(dot(normal, other) / 2.0 + 0.5, 1.0);
    if (!(facing > 0.0 && is_finite(depth_difference) && normal_power > 0.0 && position_power >= 0.0))
        return 0.0;
    return pow(facing, normal_power) * pow(1.0 + abs(depth_difference), -position_power);
}

// The sum over the window, the pixel itself with weight 1.
inline double gloam_geometry_blur(glm::ivec2 pixel, glm::ivec2 axis, glm::ivec2 size, int half_width,
                                  dvec2 powers, const Fetch<double>& fetch_occlusion,
                                  const Fetch<double>& fetch_depth, const Fetch<dvec3>& fetch_normal) {
    const double own = fetch_occlusion(pixel);
    const double center = fetch_depth(pixel);
    if (gloam_is_background(center)) return gloam_unit_interval(own);
    GloamWeightedMean mean = gloam_weighted_mean_add(gloam_weighted_mean_empty(), own, 1.0);
    const int reach = std::min(half_width, 64);
    for (int i = -reach; i <= reach; ++i) {
        const glm::ivec2 tap = pixel + i * axis;
        if (i == 0 || !has_pixel(size, tap) || gloam_is_background(fetch_depth(tap))) continue;
        const double weight = gloam_geometry_weight(fetch_normal(pixel), fetch_normal(tap),
                                                    center - fetch_depth(tap), powers.x, powers.y);
        mean = gloam_weighted_mean_add(mean, fetch_occlusion(tap), weight);
    }
    return gloam_weighted_mean_value(mean, own);
}

inline double gloam_shrink(double convergence, double c_adaptive) {
    if (!(c_adaptive >= 1e-30)) return 0.0;
    if (std::isnan(convergence)) return 1.0;
    if (c_adaptive > 0x1p126) return convergence >= c_adaptive ? 0.0 : 1.0;
    return max(c_adaptive - max(convergence, 0.0), 0.0) / c_adaptive;
}

inline double gloam_window_coverage(int offset, double reach) {
    return gloam_unit_interval(reach - (offset - 1.0));
}

inline double gloam_convergence_weight(dvec3 offset, double coverage, double scale, double convergence) {
    return coverage * gloam_gaussian_scaled(dot(offset, offset), scale) * convergence;
}

// The sum of eq. 10 over every pixel of the row or column.
inline double gloam_convergence_filter(glm::ivec2 pixel, glm::ivec2 axis, glm::ivec2 size, int half_width,
                                       double c_adaptive, double sigma, const Fetch<dvec2>& fetch_value,
                                       const Fetch<dvec3>& fetch_position) {
    const dvec2 own = fetch_value(pixel);
    const dvec3 center = fetch_position(pixel);
    const double reach = std::max(half_width, 0) * gloam_shrink(own.y, c_adaptive);
    GloamWeightedMean mean = gloam_weighted_mean_empty();
    for (int i = 0; i < std::max(size.x, size.y) && reach > 0.0 && center.z < 0.0; ++i) {
        const glm::ivec2 tap = pixel * (1 - axis) + i * axis;
        if (tap != min(tap, size - 1)) break;
        const int apart = std::max(std::abs(tap.x - pixel.x), std::abs(tap.y - pixel.y));
        const double coverage = std::clamp(reach - (apart - 1.0), 0.0, 1.0);
        const dvec3 position = fetch_position(tap);
        const dvec2 value = fetch_value(tap);
        if (!is_finite(position) || !(position.z < 0.0)) continue;
        const double weight = gloam_convergence_weight(
            position - center, coverage, gloam_gaussian_scale(sigma), gloam_unit_interval(value.y));
        mean = gloam_weighted_mean_add(mean, value.x, weight);
    }
    return gloam_weighted_mean_value(mean, own.x);
}

// The Gaussian over nine taps, as print rounds it.
inline double gloam_sao_blur_weight(int tap, double key_difference, double slope) {
    if (tap < -4 || tap > 4) return 0.0;
    double sum = 0.0;
    for (int r = -4; r <= 4; ++r) sum += exp(-r * r / 18.0);
    const double gaussian = std::round(1e6 * exp(-tap * tap / 18.0) / sum) / 1e6;
    const double fall = key_difference == 0.0 || slope <= 0.0 ? 0.0 : slope * abs(key_difference);
    return tap == 0 ? gaussian : (0.3 + gaussian) * max(0.0, 1.0 - fall);
}

inline glm::ivec2 gloam_half_size(glm::ivec2 size) {
    return {size.x / 2 + size.x % 2, size.y / 2 + size.y % 2};
}

inline glm::ivec2 gloam_half_source(glm::ivec2 pixel) {
    return {pixel.x * 2, pixel.y * 2};
}

inline bool gloam_dual_resolution_disagrees(glm::ivec2 pixel, glm::ivec2 size, double tolerance,
                                            const Fetch<double>& fetch_occlusion) {
    double low = 1.0;
    double high = 0.0;
    for (int i = 0; i < 9; ++i) {
        const glm::ivec2 at = pixel + glm::ivec2(i % 3, i / 3) - 1;
        if (!has_pixel(size, at)) continue;
        const double occlusion = fetch_occlusion(at);
        if (!(occlusion >= 0.0 && occlusion <= 1.0)) return true;
        low = min(low, occlusion);
        high = max(high, occlusion);
    }
    return !(high - low <= tolerance);
}

inline int gloam_depth_rank(dvec4 depths, int index) {
    const int own = std::clamp(index, 0, 3);
    int rank = 0;
    for (int i = 0; i < 4; ++i) rank += std::pair(depths[i], i) < std::pair(depths[own], own) ? 1 : 0;
    return rank;
}

// A half each for the two in the middle of the order of depth, or one for the second.
inline dvec4 gloam_mssao_weights(dvec4 depths, double tolerance) {
    std::array<std::pair<double, int>, 4> order;
    for (int i = 0; i < 4; ++i) order[i] = {gloam_is_background(depths[i]) ? infinity : depths[i], i};
    std::ranges::sort(order);
    dvec4 weights(0.0);
    if (std::isinf(order[0].first)) return weights;
    if (std::isinf(order[1].first)) {
        weights[order[0].second] = 1.0;
        return weights;
    }
    const bool together = order[3].first - order[0].first <= tolerance && is_finite(order[3].first);
    weights[order[1].second] = together ? 0.5 : 1.0;
    weights[order[2].second] = together ? 0.5 : 0.0;
    return weights;
}

inline dvec3 gloam_mssao_normal(dvec3 second, dvec3 third) {
    return gloam_safe_normalize((second + third) / 2.0, gloam_safe_normalize(second, dvec3(0.0)));
}

inline double gloam_mssao_upsample_weight(double bilinear, double depth_difference, double normal_cosine,
                                          double depth_power, double normal_power) {
    const bool known = abs(depth_difference) <= 1e30 && !std::isnan(normal_cosine);
    if (!known || !(depth_power >= 0.0 && normal_power >= 0.0)) return 0.0;
    return gloam_unit_interval(bilinear) * pow(1.0 / (1.0 + abs(depth_difference)), depth_power) *
           pow((glm::clamp(normal_cosine, -1.0, 1.0) + 1.0) / 2.0, normal_power);
}

inline unsigned gloam_frame_code(double depth, double occlusion, double weight) {
    const int exponent = std::ilogb(depth);
    const double part = std::ldexp(depth, -exponent) - 1.0;
    return (static_cast<unsigned>(exponent + 15) << 10U) + static_cast<unsigned>(part * 1024.0) +
           (static_cast<unsigned>(std::floor(255.0 * occlusion + 0.5)) << 16U) +
           (static_cast<unsigned>(std::floor(127.0 * weight / 1.6 + 0.5)) << 25U);
}

struct GloamFrameTexel {
    double depth;
    double occlusion;
    double weight;
    unsigned moved;
};

inline GloamFrameTexel gloam_frame_texel(unsigned code) {
    const int exponent = static_cast<int>(code % 32768U / 1024U);
    const double part = (exponent > 0 ? 1.0 : 0.0) + code % 1024U / 1024.0;
    return {std::ldexp(part, std::max(exponent, 1) - 15), static_cast<double>(code / 65536U % 256U),
            static_cast<double>(code / 16777216U), code / 16777216U % 2U};
}

inline dvec2 gloam_near_pair(dvec2 depths, double own, dvec2 scale, double alone) {
    const double bend = 2.0 * abs((depths.x + depths.y) / 2.0 - own);
    const double together = clamp(1.25 - bend * scale.x, 0.0, 1.0);
    return max(dvec2(together), alone - abs(own - depths) * scale.y);
}

inline double gloam_tile_deviation(unsigned sum, unsigned squares, unsigned count) {
    const double mean = static_cast<double>(sum) / count;
    return std::sqrt(max(static_cast<double>(squares) / count - mean * mean, 0.0));
}

}  // namespace gloam::reference
