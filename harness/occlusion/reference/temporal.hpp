// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "reference/geometry_camera.hpp"

// The history: what it holds, when it is kept, how it grows.
namespace gloam::reference {

struct GloamHistory {
    double occlusion;
    double weight;
    unsigned index;
    double depth;
};

inline GloamHistory gloam_history_empty(double depth) {
    return {0.0, 0.0, 0U, gloam_is_background(depth) ? infinity : depth};
}

// Whether a sample can have the value.
inline bool is_occlusion(double x) {
    return x == gloam_unit_interval(x);
}

inline bool gloam_history_usable(double occlusion, double weight) {
    return is_occlusion(flushed(occlusion)) && flushed(weight) > 0.0 && is_finite(weight);
}

inline GloamHistory gloam_history_sanitize(GloamHistory h) {
    if (!gloam_history_usable(h.occlusion, h.weight) || gloam_is_background(h.depth))
        return gloam_history_empty(h.depth);
    return {flushed(h.occlusion), h.weight, h.index % (1U << 24U), h.depth};
}

inline dvec4 gloam_history_pack(const GloamHistory& h) {
    const GloamHistory s = gloam_history_sanitize(h);
    return {s.occlusion, s.weight, s.index, s.depth};
}

inline GloamHistory gloam_history_unpack(dvec4 texel) {
    const double index = texel.z >= 0.0 && texel.z < 0x1p24 ? texel.z : 0.0;
    return gloam_history_sanitize({texel.x, texel.y, static_cast<unsigned>(index), texel.w});
}

// (j + k) mod N, in 64 bits.
inline unsigned gloam_next_index(unsigned index, unsigned k, unsigned table_size) {
    const std::uint64_t size = table_size - 1U < 1U << 24U ? table_size : 1U << 24U;
    return static_cast<unsigned>((std::uint64_t{index} + k) % size);
}

// Of so many samples of one value, those that a mean of at most `most` keeps.
inline double gloam_history_weight(double history, double weight, double weight_max) {
    const double kept = gloam_positive_length(flushed(weight));
    return is_occlusion(flushed(history)) ? min(kept, gloam_positive_length(flushed(weight_max))) : 0.0;
}

// The mean of all samples: those that the history stands for, each its mean, and k new ones, each C.
inline dvec2 gloam_blend(double history, double weight, double contribution, double k, double weight_max) {
    const bool taken = is_finite(contribution) && is_finite(k);
    const dvec2 counts(gloam_history_weight(history, weight, weight_max), taken ? max(flushed(k), 0.0) : 0.0);
    const dvec2 values(gloam_unit_interval(history), gloam_unit_interval(contribution));
    const double samples = counts.x + counts.y;
    return {samples > 0.0 ? dot(counts, values) / samples : 0.0,
            min(samples, gloam_positive_length(flushed(weight_max)))};
}

inline double gloam_convergence(double weight, double weight_max) {
    if (!(weight_max >= float_min)) return 1.0;
    return weight >= weight_max ? 1.0 : gloam_unit_interval(weight / weight_max);
}

inline bool gloam_rotation_enabled(double convergence, double c_rot) {
    return !(convergence >= c_rot);  // NaN: an unknown convergence is none
}

inline int gloam_sample_count(double convergence, double c_spatial, int k_initial, int k_converged) {
    return std::max(convergence >= c_spatial ? k_converged : k_initial, 0);
}

inline bool gloam_depth_consistent(double stored_depth, double expected_depth, double epsilon) {
    if (gloam_is_background(stored_depth) || gloam_is_background(expected_depth)) return false;
    return abs(1.0 - expected_depth / stored_depth) < epsilon;
}

// | |s - p| - |s' - p'| |.
inline double gloam_neighborhood_change(dvec3 sample_position, dvec3 position, dvec3 previous_sample,
                                        dvec3 previous_position) {
    const dvec3 now = sample_position - position;
    const dvec3 before = previous_sample - previous_position;
    if (!is_finite(now) || !is_finite(before)) return float_max;
    return min(abs(length(now) - length(before)), float_max);
}

inline bool gloam_neighborhood_unchanged(double change, double epsilon) {
    return change <= epsilon && change < float_max;
}

inline bool gloam_probe_useful(dvec3 offset, dvec3 normal) {
    return is_finite(offset) && dot(offset, normal) > 0.0;
}

inline double gloam_probe_change(dvec3 now, dvec3 before, dvec3 normal, double reach) {
    if (!is_finite(now) || !is_finite(before) || !is_finite(normal)) return float_max;
    const auto [nearer, farther] = std::minmax({length(now), length(before)});
    return nearer <= reach && dot(now, normal) > 0.0 ? min(farther - nearer, float_max) : 0.0;
}

inline double gloam_invalidate_clamp(double weight, double weight_small) {
    return weight > 0.0 && weight_small > 0.0 ? min(weight, weight_small) : 0.0;
}

inline double gloam_confidence(double change, double factor) {
    if (!is_finite(change) || !is_finite(factor)) return 0.0;
    const double confidence = 1.0 / (1.0 + max(factor, 0.0) * abs(change));
    return confidence >= float_min ? confidence : 0.0;
}

inline double gloam_invalidate_confidence(double weight, double confidence) {
    return weight > 0.0 && is_finite(weight) ? weight * gloam_unit_interval(confidence) : 0.0;
}

// Form (a) or (b) of smooth invalidation, of what exceeds rounding; else nothing is lost.
inline double gloam_invalidated_weight(double weight, double change, double radius, unsigned invalidation,
                                       double tolerance, double weight_small, double factor) {
    const double excess = max(change - tolerance, 0.0);
    const double kept[] = {weight, excess > 0.0 ? min(weight, weight_small) : weight,
                           weight / (1.0 + factor * excess / radius)};
    return kept[invalidation < 3U ? invalidation : 0U];
}

// The mean of both by their shares; what is no occlusion has none.
inline double gloam_temporal_smooth(double history, bool valid, double current, double rate) {
    const double now = std::isnan(rate) ? 1.0 : gloam_unit_interval(rate);
    const bool old = valid && is_occlusion(history);
    const double share = is_occlusion(current) ? (old ? now : 1.0) : 0.0;
    return mix(old ? history : 0.0, gloam_unit_interval(current), share);
}

inline dvec4 gloam_bilinear_weights(dvec2 fraction) {
    const double x = gloam_unit_interval(fraction.x);
    const double y = gloam_unit_interval(fraction.y);
    return {(1.0 - x) * (1.0 - y), x * (1.0 - y), (1.0 - x) * y, x * y};
}

inline dvec4 gloam_validated_weights(dvec4 bilinear, glm::bvec4 valid) {
    double sum = 0.0;
    for (int i = 0; i < 4; ++i) sum += bilinear[i] = valid[i] ? gloam_unit_interval(bilinear[i]) : 0.0;
    return sum >= float_min ? bilinear / sum : dvec4(0.0);
}

// The mean of the four texels around that hold the surface, each weighted by its distance along x and y.
inline GloamHistory gloam_reprojected_history(dvec2 uv, glm::ivec2 size, double expected_depth,
                                              double epsilon, const Fetch<dvec4>& fetch_history) {
    GloamHistory mean = gloam_history_empty(expected_depth);
    if (!gloam_inside_unit(uv) || size.x < 1 || size.y < 1) return mean;
    const dvec2 x = gloam_texel_position(uv.x, size.x);
    const dvec2 y = gloam_texel_position(uv.y, size.y);
    double total = 0.0;
    double most = 0.0;
    for (const glm::ivec2 step : {glm::ivec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
        const glm::ivec2 texel = gloam_clamp_to_edge(glm::ivec2(x[0], y[0]) + step, size);
        const GloamHistory one = gloam_history_unpack(fetch_history(texel));
        if (!gloam_depth_consistent(one.depth, expected_depth, epsilon)) continue;
        const double weight = (1.0 - abs(x[1] - step.x)) * (1.0 - abs(y[1] - step.y));
        total += weight;
        mean.occlusion += weight * one.occlusion;
        mean.weight += weight * one.weight;
        if (weight > most) mean.index = one.index;
        most = max(most, weight);
    }
    return gloam_history_sanitize(
        {min(mean.occlusion / total, 1.0), mean.weight / total, mean.index, mean.depth});
}

// Nearest: the texel that the point is in. Bilinear: all four, where that one holds the surface.
inline GloamHistory gloam_reprojected_point(dvec3 previous, const GloamCamera& camera, unsigned taps,
                                            double epsilon, const Fetch<dvec4>& fetch_history) {
    const dvec2 uv = gloam_camera_uv(previous, camera);
    if (!gloam_inside_unit(uv)) return gloam_history_empty(-previous.z);
    const auto at = [&](dvec2 place, double tolerance) {
        return gloam_reprojected_history(place, camera.size, -previous.z, tolerance, fetch_history);
    };
    const GloamHistory nearest = at(gloam_pixel_center(uv, camera.size), epsilon);
    const bool all = taps == 1U && nearest.weight > 0.0;
    return taps < 2U && !all ? nearest : at(uv, all ? infinity : epsilon);
}

inline dvec3 gloam_frame_before(dvec2 pixel, double depth, glm::dmat4x3 m, bool orthographic) {
    if (orthographic) return m * dvec4(pixel, 1.0, depth);
    const dvec3 before = m * dvec4(pixel * depth, depth, 1.0);
    return {before.x / before.z, before.y / before.z, before.z};
}

// Nearer, or farther, than each of the four by more than the tolerance.
inline bool gloam_frame_moved(double depth, dvec4 before, double far, double tolerance) {
    bool nearer = true;
    bool farther = true;
    for (int i = 0; i < 4; ++i) {
        nearer = nearer && min(depth, far) < min(before[i], far) * (1.0 - tolerance);
        farther = farther && min(depth, far) > before[i] * (1.0 + tolerance);
    }
    return nearer || farther;
}

inline double gloam_frame_sharp(dvec2 own, dvec2 all, double part) {
    return (own.x * part + all.x * (1.0 - part)) / (own.y * part + all.y * (1.0 - part));
}

inline dvec2 gloam_frame_blend(double mean, double fast, double weight, double fresh, double filtered,
                               double range) {
    const double quick = std::max(weight, 0.7);
    const double now = fast * (1.0 - quick) + filtered * quick;
    const double kept = std::min(std::max(mean, now - range), now + range);
    return {kept * (1.0 - weight) + fresh * weight, now};
}

}  // namespace gloam::reference
