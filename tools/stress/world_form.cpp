// SPDX-License-Identifier: MIT
#include "stress/world_form.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gloam::stress {
namespace {

constexpr const char* file = "gloam/geometry/reprojection.glsl";

// World to view and back, formed in double and rounded once, as a careful engine hands them to a shader.
struct Views {
    explicit Views(const scene::Camera& camera) {
        const glm::dmat3 rotation = scene::view_rotation(camera);
        glm::dmat4 world_to_view(rotation);
        world_to_view[3] = glm::dvec4(rotation * -camera.eye, 1.0);
        glm::dmat4 view_to_world(glm::transpose(rotation));
        view_to_world[3] = glm::dvec4(camera.eye, 1.0);
        view = glm::mat4(world_to_view);
        inverse = glm::mat4(view_to_world);
    }
    glm::mat4 view{1};
    glm::mat4 inverse{1};
};

glm::dvec4 clip_of(const scene::Camera& camera, const glm::dvec3& point) {
    return projection_of(camera) * glm::dvec4(in_view(camera, point), 1.0);
}

void meet(ReprojectionErrors& worst, const glm::dvec4& clip, const glm::dvec4& exact) {
    worst.pixels = std::max(worst.pixels, pixels_between(clip, exact));
    for (int i = 0; i < 4; ++i) worst.clip = std::max(worst.clip, std::abs(clip[i] - exact[i]));
}

}  // namespace

glm::dvec3 in_view(const scene::Camera& camera, const glm::dvec3& point) {
    return scene::view_rotation(camera) * (point - camera.eye);
}

double pixels_between(const glm::dvec4& clip, const glm::dvec4& exact) {
    if (!(clip.w > 0.0)) return std::numeric_limits<double>::infinity();
    const glm::dvec2 apart = glm::dvec2(clip) / clip.w - glm::dvec2(exact) / exact.w;
    return glm::length(0.5 * apart * glm::dvec2(image_width, image_height));
}

WorldForm::WorldForm(const check::Lab& lab)
    : previous_static_(lab, file, "gloam_previous_clip_static"),
      previous_moving_(lab, file, "gloam_previous_clip_moving"),
      previous_depth_(lab, file, "gloam_previous_depth") {}

ReprojectionErrors WorldForm::still(const MovedPoints& all) const {
    const Views now(all.now);
    const Views before(all.before);
    const glm::mat4 projection(projection_of(all.before));
    const glm::mat4 inverse_projection(glm::inverse(projection_of(all.now)));
    std::vector<decltype(previous_static_)::Inputs> clips;
    std::vector<decltype(previous_depth_)::Inputs> positions;
    for (const glm::dvec3& point : all.points) {
        clips.emplace_back(glm::vec4(clip_of(all.now, point)), inverse_projection, now.inverse, before.view,
                           projection);
        positions.emplace_back(glm::vec3(point), before.view);
    }
    const std::vector<glm::vec4> got = previous_static_(clips);
    const std::vector<float> depths = previous_depth_(positions);
    ReprojectionErrors worst;
    for (std::size_t i = 0; i < got.size(); ++i) {
        meet(worst, glm::dvec4(got[i]), clip_of(all.before, all.points[i]));
        const double depth = -in_view(all.before, all.points[i]).z;
        worst.relative_depth = std::max(worst.relative_depth, std::abs(double{depths[i]} - depth) / depth);
    }
    return worst;
}

ReprojectionErrors WorldForm::moving(const MovedPoints& all) const {
    const Views now(all.now);
    const Views before(all.before);
    const glm::mat4 projection(projection_of(all.before));
    const glm::mat4 inverse_projection(glm::inverse(projection_of(all.now)));
    glm::mat4 model(1.0F);
    glm::mat4 inverse_model(1.0F);
    model[3] = glm::vec4(glm::vec3(all.shift), 1.0F);
    inverse_model[3] = glm::vec4(glm::vec3(-all.shift), 1.0F);
    std::vector<decltype(previous_moving_)::Inputs> clips;
    for (const glm::dvec3& point : all.points) {
        clips.emplace_back(glm::vec4(clip_of(all.now, point)), inverse_projection, now.inverse, inverse_model,
                           model, before.view, projection);
    }
    const std::vector<glm::vec4> got = previous_moving_(clips);
    ReprojectionErrors worst;
    for (std::size_t i = 0; i < got.size(); ++i)
        meet(worst, glm::dvec4(got[i]), clip_of(all.before, all.points[i]));
    return worst;
}

}  // namespace gloam::stress
