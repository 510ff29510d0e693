// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/length.hpp"
#include "reference/numeric/inverse_trigonometry.hpp"
#include "reference/numeric/sincos.hpp"
#include "reference/shading/remap.hpp"

namespace gloam::reference {

inline double gloam_tangent_slope(dvec2 direction, dvec3 dpdu, dvec3 dpdv) {
    const dvec3 t = direction.x * dpdu + direction.y * dpdv;
    return has_direction(t) ? clamp(t.z / length(dvec2(t)), -1e6, 1e6) : 0.0;
}

inline double gloam_sine_of_tangent(double tangent) {
    return std::isnan(tangent) ? 0.0 : sin(atan(tangent));
}

inline double gloam_tangent_elevation(dvec3 normal, dvec2 direction) {
    return clamp(gloam_atan2(-dot(dvec2(normal), direction), normal.z), -pi / 2.0, pi / 2.0);
}

inline dvec2 gloam_hbao_start(double tangent, double bias) {
    const double elevation = tangent + bias;
    return {std::isnan(elevation) ? 1.0 : sin(clamp(elevation, -pi / 2.0, pi / 2.0)), 0.0};
}

inline dvec2 gloam_hbao_horizon(dvec3 normal, dvec2 direction, dvec2 bias) {
    const double across = dot(dvec2(normal), direction);
    const double away = across > 0.0 ? -pi / 2.0 : pi / 2.0;
    const double elevation = normal.z > 0.0 ? -atan(across / normal.z) : away;
    return on_circle(min(elevation + std::atan2(bias.y, bias.x), pi / 2.0));
}

inline dvec2 gloam_hbao_start_slope(double slope, double bias) {
    if (!(bias >= 0.0 && bias < 1.57079625F) || std::isnan(slope)) return {1.0, 0.0};
    return {sin(atan(slope + tan(bias))), 0.0};
}

inline dvec2 gloam_hbao_step(dvec2 horizon, dvec3 offset, double radius) {
    const double r = length(offset);
    if (!(has_direction(offset) && radius >= float_min && radius <= 0x1p126 && r < radius)) return horizon;
    const double sine = offset.z / r;
    if (!(sine > horizon.x)) return horizon;
    return {sine, horizon.y + (1.0 - pow(r / radius, 2)) * (sine - horizon.x)};
}

inline dvec2 gloam_hbao_step_size(double radius, double largest, double steps, double extra) {
    const double reach = radius < largest ? radius : largest;
    if (!(reach >= 1.0 && reach <= 0x1p126 && steps >= 1.0 && extra >= 0.0)) return dvec2(0.0);
    const double count = floor(min(steps, reach));
    return {reach / (count + extra), count};
}

inline double gloam_hbao_visibility(double occlusion, double bias, double contrast) {
    if (!(abs(bias) < 1.5 && occlusion > 0.0 && contrast > 0.0)) return 1.0;
    return max(1.0 - contrast * occlusion / (1.0 - sin(bias)), 0.0);
}

inline double gloam_contribution_hbao_simplified(dvec3 offset, dvec3 normal, double radius, double bias) {
    const double r = length(offset);
    const bool near = has_direction(offset) && radius >= float_min && radius <= 0x1p126 && r < radius;
    const double above = dot(normal, offset) / r - bias;
    if (!(near && above > 0.0 && bias >= 0.0 && bias < 1.0)) return 0.0;
    return min(above / (1.0 - bias), 1.0) * (1.0 - pow(r / radius, 2));
}

inline double gloam_visibility_hbao_simplified(dvec2 accumulated, double power) {
    if (!(accumulated.y >= 1.0 && accumulated.x > 0.0)) return 1.0;
    return gloam_remap(1.0 - 2.0 * accumulated.x / accumulated.y, 0.0, 1.0, power);
}

}  // namespace gloam::reference
