// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "reference/filter.hpp"
#include "reference/shading.hpp"

// Contributions of the surface points around, and what becomes of their sum.
namespace gloam::reference {

inline double gloam_contribution_fox_compton_unscaled(dvec3 offset, dvec3 normal, double epsilon) {
    if (!(length(offset) > 0.0)) return 0.0;
    return max(dot(normalize(offset), normal), 0.0) / max(epsilon, length(offset));
}

inline double gloam_contribution_fox_compton(dvec3 offset, dvec3 normal, double epsilon) {
    if (!(length(offset) > 0.0)) return 0.0;
    return max(dot(normalize(offset), normal), 0.0) * min(max(epsilon, 0.0) / length(offset), 1.0);
}

inline double gloam_contribution_aksoy_phaneuf(dvec3 offset, dvec3 normal, double radius, double bias) {
    return dot(offset, normal) > bias ? max(1.0 - length(offset) / radius, 0.0) : 0.0;
}

inline double gloam_two_radii_sum(double fine, double broad) {
    return min(gloam_unit_interval(fine) + gloam_unit_interval(broad), 1.0);
}

inline double gloam_contribution_alchemy(dvec3 offset, dvec3 normal, double bias, double epsilon,
                                         double scale) {
    const double above = dot(offset, normal) - bias;
    return above > 0.0 ? scale * above / (dot(offset, offset) + epsilon) : 0.0;
}

inline double gloam_contribution_sao(dvec3 offset, dvec3 normal, double radius, double bias, double epsilon,
                                     double scale) {
    const double vv = dot(offset, offset);
    const double above = dot(offset, normal) - bias;
    if (!(vv < pow(radius, 2) && above > 0.0)) return 0.0;
    return scale * pow(1.0 - vv / pow(radius, 2), 3) * above / (vv + epsilon);
}

inline double gloam_issao_attenuation(double hit_distance, double phi, double mu) {
    const double d = abs(hit_distance);
    if (!(d > 0.0 && phi > 0.0 && mu >= float_min && max(mu, d) <= 0x1p126)) return 0.0;
    const double q = phi * d / pow(max(mu, d), 2);
    return is_finite(q) ? q : 0.0;
}

inline double gloam_contribution_issao_basic(dvec3 offset, dvec3 normal, double radius) {
    return gloam_length(offset) < radius ? gloam_sample_cosine(offset, normal) : 0.0;
}

inline double gloam_contribution_issao_attenuated(dvec3 offset, dvec3 normal, double radius, double phi,
                                                  double mu) {
    if (!(gloam_length(offset) < radius)) return 0.0;
    return gloam_issao_attenuation(gloam_length(offset), phi, mu) * gloam_sample_cosine(offset, normal);
}

inline double gloam_contribution_issao(dvec3 offset, dvec3 normal, double radius, double phi, double bias,
                                       double sigma) {
    const double above = dot(offset, normal) - bias;
    if (!(length(offset) < radius && above > 0.0)) return 0.0;
    return phi * above / (dot(offset, offset) + sigma);
}

inline double gloam_issao_occlusion(dvec2 accumulated, double lambda) {
    if (!(accumulated.y >= 1.0 && accumulated.x > 0.0 && lambda > 0.0)) return 0.0;
    return gloam_unit_interval(lambda / accumulated.y * accumulated.x);
}

inline double gloam_contribution_mssao(dvec3 offset, dvec3 normal, double radius) {
    const double d = length(offset);
    if (!has_direction(offset) || std::isnan(dot(offset, normal)) || !(radius >= float_min)) return 0.0;
    return (1.0 - pow(min(d / radius, 1.0), 2)) * clamp(dot(offset, normal) / d, 0.0, 1.0);
}

inline double gloam_mssao_combine(double largest, double mean) {
    return 1.0 - (1.0 - gloam_unit_interval(largest)) * (1.0 - gloam_unit_interval(mean));
}

inline double gloam_separable_mean(double along_u, double along_v) {
    return (gloam_unit_interval(along_u) + gloam_unit_interval(along_v)) / 2.0;
}

inline double gloam_separable_weight(dvec3 offset, dvec3 normal, double sigma, double tolerance) {
    return abs(dot(offset, normal)) <= tolerance ? gloam_gaussian(dot(offset, offset), sigma) : 0.0;
}

inline dvec2 gloam_disc_share(double area, double distance_to) {
    if (!(area >= float_min * float_min && distance_to >= 0.0)) return {0.0, 1.0};
    if (std::isinf(area)) return std::isinf(distance_to) ? dvec2(0.5) : dvec2(1.0, 0.0);
    const double larger = area / (area + pi * pow(distance_to, 2));
    return {larger, 1.0 - larger};
}

inline double gloam_contribution_disc_proxy_cosine(dvec3 offset, dvec3 normal, dvec3 emitter_normal,
                                                   double area, double weight) {
    const double d = length(offset);
    const dvec2 cosines(-dot(offset, emitter_normal) / d, dot(offset, normal) / d);
    if (!has_direction(offset) || !(cosines.x > 0.0 && cosines.y > 0.0 && area > 0.0)) return 0.0;
    const double share = 1.0 / (1.0 + pi * d * d / area);
    return gloam_unit_interval(weight) * share * min(cosines.x, 1.0) * min(cosines.y, 1.0);
}

inline double gloam_sphere_fraction(double radius, double distance_to) {
    if (!(radius > 0.0 && distance_to >= 0.0)) return 0.0;
    const double half_angle = asin(std::min(1.0, radius / abs(distance_to)));  // from inside all is ball
    return 2.0 * pow(sin(half_angle / 2.0), 2);                                // 1 - cos
}

inline double gloam_contribution_sphere(dvec3 offset, dvec3 normal, double radius) {
    if (!is_finite(offset)) return 0.0;
    const double cosine = gloam_length(offset) <= radius ? 1.0 : gloam_sample_cosine(offset, normal);
    return gloam_sphere_fraction(radius, gloam_length(offset)) * cosine;
}

inline double gloam_contribution_sphere_cosine(dvec3 offset, dvec3 normal, double radius) {
    if (!is_finite(offset) || !(radius > 0.0)) return 0.0;
    const double d = gloam_length(offset);
    return d <= radius ? 1.0 : pow(radius / d, 2) * gloam_sample_cosine(offset, normal);
}

inline double gloam_above_horizon(dvec3 offset, double tan_horizon) {
    const double across = gloam_length(dvec3(offset.x, offset.y, 0.0));
    const double horizon = across > 0.0 ? tan_horizon * across : 0.0;
    return is_finite(offset) && offset.z > horizon ? 1.0 : 0.0;
}

// The cosine to the view vector of a direction, which is moved along the normal into the tangent plane from
// below it.
inline double gloam_lifted_cosine(dvec3 offset, dvec3 normal, dvec3 view) {
    dvec3 direction = gloam_safe_normalize(offset, dvec3(0.0));
    if (dot(direction, normal) < 0.0) direction -= dot(direction, normal) * normal;
    const double left = length(direction);
    return left > 1e-3 ? cosine_in_range(dot(view, direction) / left) : 0.0;
}

inline bool gloam_sample_near(dvec3 offset, double range) {
    return offset.z <= range;
}

// An invalid sample has the direction opposite to its partner's.
inline dvec3 gloam_angle_pair(dvec3 first, dvec3 second, dvec3 normal, dvec3 view, double range) {
    const bool a = gloam_sample_near(first, range);
    const bool b = gloam_sample_near(second, range);
    if (!a && !b) return dvec3(0.0);
    const auto mirrored = [&](dvec3 partner) {
        return gloam_unit_interval(dot(view, gloam_safe_normalize(-partner, dvec3(0.0))));
    };
    return {a ? gloam_lifted_cosine(first, normal, view) : mirrored(second),
            b ? gloam_lifted_cosine(second, normal, view) : mirrored(first), a && b ? 1.0 : 0.5};
}

inline double gloam_contribution_unreal(dvec3 offset, dvec3 normal, double bias, double scale) {
    const double above = dot(offset, normal);
    return above > bias ? min(scale * above / dot(offset, offset), 1.0) : 0.0;
}

inline double gloam_unreal_side(double occlusion) {
    return pow(1.0 - gloam_unit_interval(occlusion), 2);
}

inline double gloam_unreal_visibility(double ao, double power, double intensity) {
    const double visibility = 1.0 - (1.0 - gloam_remap(ao, 0.0, 1.0, power)) * intensity;
    return std::isnan(visibility) ? 1.0 : gloam_unit_interval(visibility);
}

inline double gloam_chord_half_height(dvec2 xi, double radius) {
    const double squared = 1.0 - dot(xi, xi);
    return squared >= float_min && radius > 0.0 ? radius * sqrt(squared) : 0.0;
}

inline double gloam_line_ratio(double height, double half_height) {
    if (!(half_height >= float_min && half_height <= 0x1p126) || std::isnan(height)) return 0.5;
    return (half_height + height) / (2.0 * half_height);
}

inline double gloam_line_occlusion(double height, double half_height) {
    return gloam_unit_interval(gloam_line_ratio(height, half_height));
}

inline dvec2 gloam_line_pair(dvec2 ratios, double lowest, double highest) {
    const bool first = ratios.x >= lowest && ratios.x <= highest;
    const bool second = ratios.y >= lowest && ratios.y <= highest;
    if (!first && !second) return dvec2(0.5);
    return {first ? ratios.x : 1.0 - ratios.y, second ? ratios.y : 1.0 - ratios.x};
}

// The mean of the solid part over heights in [m - w, m + w], piece by piece: linear between the chord's ends.
inline double gloam_area_occlusion(double height, double half_width, double half_height) {
    if (!(half_width > 0.0)) return gloam_line_occlusion(height, half_height);
    if (!(half_height >= float_min && max(half_height, half_width) <= 0x1p126) || std::isnan(height))
        return 0.5;
    if (!is_finite(height) || half_width < 1e-9 * abs(height))
        return gloam_line_occlusion(height, half_height);
    const double low = height - half_width;
    const double high = height + half_width;
    const double ends[] = {low, clamp(-half_height, low, high), clamp(half_height, low, high), high};
    double integral = 0.0;
    for (int i = 0; i < 3; ++i) {
        const double sum =
            gloam_line_occlusion(ends[i], half_height) + gloam_line_occlusion(ends[i + 1], half_height);
        integral += 0.5 * sum * (ends[i + 1] - ends[i]);
    }
    return integral / (high - low);
}

inline double gloam_two_balls(double fine, double broad) {
    const auto excess = [](double solid) { return is_finite(solid) ? solid - 0.5 : 0.0; };
    return gloam_unit_interval(0.5 + excess(fine) + excess(broad));
}

// Of the sphere of radius r / 2 around n r / 2.
inline double gloam_tangent_sphere_half_height(dvec3 offset, dvec3 normal, double radius) {
    if (!(radius >= float_min && radius <= 0x1p126)) return 0.0;
    return gloam_chord_half_height(dvec2(offset) / (radius / 2.0) - dvec2(normal), radius / 2.0);
}

inline double gloam_tangent_sphere_occlusion(dvec3 offset, dvec3 normal, double radius) {
    const double half_height = gloam_tangent_sphere_half_height(offset, normal, radius);
    const double height = offset.z - radius / 2.0 * normal.z;
    return half_height >= float_min && !std::isnan(height) ? gloam_line_occlusion(height, half_height) : 0.0;
}

}  // namespace gloam::reference
