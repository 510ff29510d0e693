// SPDX-License-Identifier: MIT
#include "stress/centered_form.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stress/world_form.hpp"

namespace gloam::stress {

std::vector<check::Word> CenteredResults::words() const {
    std::vector<check::Word> all;
    check::append_words(previous_from_current, all);
    for (const glm::vec3& q : previous) check::append_words(q, all);
    for (const float depth : previous_depth) check::append_words(depth, all);
    for (const auto& [inside, uv] : texture) {
        check::append_words(inside, all);
        check::append_words(uv, all);
    }
    return all;
}

CenteredForm::CenteredForm(const check::Lab& lab)
    : previous_(lab, "gloam/geometry/camera_centered.glsl", "gloam_camera_centered_previous"),
      previous_depth_(lab, "gloam/geometry/reprojection.glsl", "gloam_previous_depth"),
      reproject_(lab, "gloam/geometry/reprojection.glsl", "gloam_reproject_clip") {}

CenteredResults CenteredForm::run(const MovedPoints& all) const {
    const scene::CameraFrame frame = scene::make_frame(all.now, aspect, all.before);
    CenteredResults results{.previous_from_current = frame.previous_from_current.value()};
    const glm::dmat4 projection = projection_of(all.now);
    const glm::mat4 matrix(projection_of(all.before) * glm::dmat4(results.previous_from_current) *
                           glm::inverse(projection));
    const glm::vec3 eye_delta(all.now.eye - all.before.eye);
    const glm::mat4 rotation_before(glm::dmat4(scene::view_rotation(all.before)));
    std::vector<decltype(previous_)::Inputs> positions;
    std::vector<decltype(reproject_)::Inputs> clips;
    for (const glm::dvec3& point : all.points) {
        positions.emplace_back(glm::vec3(point - all.now.eye), eye_delta);
        const glm::dvec4 clip = projection * glm::dvec4(in_view(all.now, point), 1.0);
        clips.emplace_back(glm::vec4(clip), matrix);
    }
    results.previous = previous_(positions);
    results.texture = reproject_(clips);
    std::vector<decltype(previous_depth_)::Inputs> centered;
    for (const glm::vec3& q : results.previous) centered.emplace_back(q, rotation_before);
    results.previous_depth = previous_depth_(centered);
    return results;
}

double CenteredForm::pixels(const MovedPoints& all, const CenteredResults& results) {
    double worst = 0.0;
    for (std::size_t i = 0; i < all.points.size(); ++i) {
        const auto& [inside, uv] = results.texture[i];
        if (!inside) return std::numeric_limits<double>::infinity();
        const glm::dvec4 got(2.0 * glm::dvec2(uv) - 1.0, 0.0, 1.0);
        const glm::dvec4 exact =
            projection_of(all.before) * glm::dvec4(in_view(all.before, all.points[i]), 1.0);
        worst = std::max(worst, pixels_between(got, exact));
    }
    return worst;
}

double CenteredForm::depth_error(const MovedPoints& all, const CenteredResults& results) {
    double worst = 0.0;
    for (std::size_t i = 0; i < all.points.size(); ++i) {
        const glm::dvec3 at = in_view(all.before, all.points[i]);
        worst = std::max(worst, std::abs(double{results.previous_depth[i]} + at.z) / glm::length(at));
    }
    return worst;
}

}  // namespace gloam::stress
