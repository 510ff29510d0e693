// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "judge/question.hpp"
#include "subject/domain.hpp"

// Values and images that several entries use.
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

// Whether a vector has length 1; accuracy is promised for such normals.
[[nodiscard]] inline bool is_unit(const glm::dvec3& n) {
    return std::abs(glm::length(n) - 1.0) <= 1e-6;
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

// GloamCamera: perspective or orthographic, with the size of the run's images (1 x 1 besides special values).
[[nodiscard]] check::Values cameras();

// Returns an adjustment: the vec3 at word `position` of a row, drawn as (ndc, depth), becomes the view-space
// position there in the GloamCamera at word `camera`. Special values, which are not (ndc, depth), are kept.
[[nodiscard]] std::function<void(std::span<check::Word>)> place_before_camera(std::size_t position,
                                                                              std::size_t camera);

// Images of the sizes on which every image-reading function is checked: 1 x 1, odd, wide, tall.
// `make`: fills them.
[[nodiscard]] std::vector<check::ImageScenario> image_scenarios(
    const std::function<check::ImageSet(glm::ivec2 size, numeric::Random& random)>& make);

// An occlusion for an image; rarely NaN, infinity, or outside [0, 1].
[[nodiscard]] float occlusion_or_worse(numeric::Random& random);

// Numbers from 0 to 1, with both ends and special values.
[[nodiscard]] check::Values shares();

// vec3: unit vectors, and special values.
[[nodiscard]] check::Values normals();

// vec3: half of the lengths are usual ones, half are any; the zero vector, and special values.
[[nodiscard]] check::Values offsets_of(const check::Values& usual, const check::Values& any);

// GloamSlice: of view vectors and normals that face the eye at a moderate angle.
[[nodiscard]] check::Values facing_slices();

// ivec2: along a row or a column.
[[nodiscard]] check::Values image_axes();

inline constexpr const char* depth_prototype = "gloam_fetch_depth";

// Eye-linear depth images (float) of those sizes for a prototype: a slanted surface with steps and holes of
// background (+infinity), and one scenario of background alone.
[[nodiscard]] std::vector<check::ImageScenario> depth_scenarios(const std::string& prototype);

}  // namespace gloam::catalogue
