// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "check/values.hpp"

// Values that several entries use.
namespace gloam::catalogue {

// Whether every scalar of the values has a magnitude in [low, high], so that products and quotients of a few
// of them neither overflow nor underflow. Zero, infinity and NaN count as moderate, because their results are
// judged.
template <class... V>
[[nodiscard]] bool moderate(double low, double high, const V&... values) {
    bool all = true;
    const auto look = [&](const auto& scalar) {
        const double magnitude = std::abs(static_cast<double>(scalar));
        all = all && !(magnitude > 0.0 && magnitude < low) && !(magnitude > high && std::isfinite(magnitude));
    };
    (check::visit_scalars(values, look), ...);
    return all;
}

// mat4: rotation and translation, up to `extent` world units from the origin (a view or model matrix, or its
// inverse).
[[nodiscard]] check::Values rigid_matrices(double extent);

// mat4: perspective projections with clip y down and depth in [0, 1], near plane 0.1 to 1. Half of them have
// an infinite far plane, and half are reversed.
[[nodiscard]] check::Values projection_matrices();
// Their inverses.
[[nodiscard]] check::Values inverse_projection_matrices();
// mat4: from the current frame's clip space to the previous one's, for cameras up to a metre and half a
// radian apart.
[[nodiscard]] check::Values reprojection_matrices();

// vec4: clip-space points inside or a little outside the frustum, (ndc, 1) or homogeneous with w from 0.1 to
// 10.
[[nodiscard]] check::Values clip_points();

// vec2: the elements (P00, P11) of a projection, either sign of y.
[[nodiscard]] check::Values projection_scales();

}  // namespace gloam::catalogue
