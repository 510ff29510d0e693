// SPDX-License-Identifier: MIT
#pragma once

#include "reference/geometry/safe_normalize.hpp"
#include "reference/numeric/inverse_trigonometry.hpp"
#include "reference/numeric/sincos.hpp"
#include "reference/numeric/square_root.hpp"
#include "reference/shading/remap.hpp"

namespace gloam::reference {

inline double gloam_tangent_slope(dvec2 direction, dvec3 dpdu, dvec3 dpdv) {
    const dvec3 t = gloam_safe_normalize(dpdu * direction.x + dpdv * direction.y, dvec3(0.0));
    const double across = gloam_sqrt(dot(dvec2(t.x, t.y), dvec2(t.x, t.y)));
    if (across > 1e-6) return clamp(t.z / across, -1e6, 1e6);
    return t.z > 0.0 ? 1e6 : (t.z < 0.0 ? -1e6 : 0.0);
}

inline double gloam_sine_of_tangent(double tangent) {
    const double magnitude = abs(tangent);
    if (!(magnitude < 1e6)) return tangent > 0.0 ? 1.0 : (tangent < 0.0 ? -1.0 : 0.0);
    return clamp(tangent / sqrt(1.0 + magnitude * magnitude), -1.0, 1.0);
}

inline double gloam_tangent_elevation(dvec3 normal, dvec2 direction) {
    return clamp(gloam_atan2(-dot(dvec2(normal.x, normal.y), direction), normal.z), -1.570796327,
                 1.570796327);
}

inline dvec2 gloam_hbao_start(double tangent, double bias) {
    const double elevation = tangent + bias;
    return dvec2(elevation < 1.570796327 ? gloam_sincos(max(elevation, -1.570796327)).y : 1.0, 0.0);
}

// sin(atan(tan t + tan bias)) = x / (1 + x^2)^(1/2).
inline dvec2 gloam_hbao_start_slope(double slope, double bias) {
    if (!(bias >= 0.0 && bias < double(1.570796251F) && abs(slope) >= 0.0)) return dvec2(1.0, 0.0);
    const dvec2 turned = gloam_sincos(bias);
    return dvec2(gloam_sine_of_tangent(slope + turned.y / turned.x), 0.0);
}

inline dvec2 gloam_hbao_step(dvec2 horizon, dvec3 offset, double radius) {
    const dvec3 direction = gloam_safe_normalize(offset, dvec3(0.0));
    const double x = dot(offset, direction) / radius;
    const bool near = radius >= float_min && radius <= 0x1p126 && x < 1.0 && dot(direction, direction) > 0.5;
    if (!(near && direction.z > horizon.x)) return horizon;
    const double sine = min(direction.z, 1.0);
    return dvec2(sine, horizon.y + (sine - horizon.x) * (1.0 - x * x));
}

inline dvec2 gloam_hbao_step_size(double radius, double largest, double steps, double extra) {
    const double reach = radius < largest ? radius : largest;
    if (!(reach >= 1.0 && reach <= 0x1p126 && steps >= 1.0 && extra >= 0.0)) return dvec2(0.0);
    const double count = floor(steps < reach ? steps : reach);
    return dvec2(reach / (count + extra), count);
}

inline double gloam_hbao_visibility(double occlusion, double bias, double contrast) {
    const double rest = 1.0 - gloam_sincos(bias).y;
    if (!(abs(bias) < 1.5 && occlusion > 0.0 && contrast > 0.0)) return 1.0;
    const double visibility = 1.0 - contrast * (occlusion / rest);
    return visibility > 0.0 ? visibility : (visibility <= 0.0 ? 0.0 : 1.0);
}

inline double gloam_contribution_hbao_simplified(dvec3 offset, dvec3 normal, double radius, double bias) {
    const dvec3 direction = gloam_safe_normalize(offset, dvec3(0.0));
    const double x = dot(offset, direction) / radius;
    const double above = dot(normal, direction) - bias;
    const bool near = radius >= float_min && radius <= 0x1p126 && x < 1.0;
    if (!(near && above > 0.0 && bias >= 0.0 && bias < 1.0)) return 0.0;
    return min(above / (1.0 - bias), 1.0) * (1.0 - x * x);
}

inline double gloam_visibility_hbao_simplified(dvec2 accumulated, double power) {
    if (!(accumulated.y >= 1.0 && accumulated.x > 0.0)) return 1.0;
    return gloam_remap(1.0 - 2.0 * (accumulated.x / accumulated.y), 0.0, 1.0, power);
}

}  // namespace gloam::reference
