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
    (subject::visit_scalars(values, look), ...);
    return all;
}

// Whether a vector has length 1; accuracy is promised for such normals.
[[nodiscard]] inline bool is_unit(const glm::dvec3& n) {
    return std::abs(glm::length(n) - 1.0) <= 1e-6;
}

// Whether a dot product of a vector whose components' magnitudes sum to at most `most` does not overflow; NaN
// counts as small.
[[nodiscard]] inline bool small(const glm::dvec3& v, double most = 1e18) {
    return !(std::abs(v.x) + std::abs(v.y) + std::abs(v.z) > most);
}

// mat4: rotation and translation, up to `extent` world units from the origin (a view or model matrix, or its
// inverse).
[[nodiscard]] subject::Values rigid_matrices(double extent);

// mat4: perspective projections with clip y down and depth in [0, 1], near plane 0.1 to 1. Half of them have
// an infinite far plane, and half are reversed.
[[nodiscard]] subject::Values projection_matrices();
// Their inverses.
[[nodiscard]] subject::Values inverse_projection_matrices();
// mat4: from the current frame's clip space to the previous one's, for cameras up to a metre and half a
// radian apart.
[[nodiscard]] subject::Values reprojection_matrices();

// vec4: clip-space points inside or a little outside the frustum, (ndc, 1) or homogeneous with w from 0.1 to
// 10.
[[nodiscard]] subject::Values clip_points();

// vec2: the elements (P00, P11) of a projection, either sign of y.
[[nodiscard]] subject::Values projection_scales();

// GloamCamera: perspective or orthographic, with the size of the run's images (1 x 1 besides special values).
[[nodiscard]] subject::Values cameras();

// Returns an adjustment: the vec3 at word `position` of a row, drawn as (ndc, depth), becomes the view-space
// position there in the GloamCamera at word `camera`. Special values, which are not (ndc, depth), are kept.
[[nodiscard]] std::function<void(std::span<subject::Word>)> place_before_camera(std::size_t position,
                                                                                std::size_t camera);

// Images of the sizes on which every image-reading function is checked: 1 x 1, odd, wide, tall.
// `make`: fills them.
[[nodiscard]] std::vector<subject::ImageScenario> image_scenarios(
    const std::function<subject::ImageSet(glm::ivec2 size, numeric::Random& random)>& make);

// An occlusion for an image; rarely NaN, infinity, or outside [0, 1].
[[nodiscard]] float occlusion_or_worse(numeric::Random& random);

// Numbers from 0 to 1, with both ends and special values.
[[nodiscard]] subject::Values shares();

// vec3: unit vectors, and special values.
[[nodiscard]] subject::Values normals();

// vec3: half of the lengths are usual ones, half are any; the zero vector, and special values.
[[nodiscard]] subject::Values offsets_of(const subject::Values& usual, const subject::Values& any);

// GloamSlice: of view vectors and normals that face the eye at a moderate angle.
[[nodiscard]] subject::Values facing_slices();

// ivec2: along a row or a column.
[[nodiscard]] subject::Values image_axes();

// What a fetch function of a shader returns: the texels of its image as T.
template <class T>
[[nodiscard]] auto fetch_of(const subject::ImageSet& images, const char* prototype) {
    return [&image = images.at(prototype)](glm::ivec2 pixel) { return image.at<T>(pixel); };
}

inline constexpr const char* depth_prototype = "gloam_fetch_depth";

// Eye-linear depth images (float) of those sizes for a prototype: a slanted surface with steps and holes of
// background (+infinity), and one scenario of background alone.
[[nodiscard]] std::vector<subject::ImageScenario> depth_scenarios(const std::string& prototype);

}  // namespace gloam::catalogue
