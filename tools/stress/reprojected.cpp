// SPDX-License-Identifier: MIT
#include "stress/reprojected.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/random.hpp"

namespace gloam::stress {
namespace {

constexpr double grid = 1'048'576.0;
constexpr double nearest = 0.5;
constexpr double farthest_move = 50.0;

glm::dvec3 on_grid(const glm::dvec3& x) {
    return glm::round(x * grid) / grid;
}

bool seen(const scene::Camera& camera, const glm::dvec3& point) {
    const glm::dvec3 at = scene::view_rotation(camera) * (point - camera.eye);
    const glm::dvec4 clip = projection_of(camera) * glm::dvec4(at, 1.0);
    return -at.z >= nearest && std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w;
}

}  // namespace

glm::dmat4 projection_of(const scene::Camera& camera) {
    return glm::dmat4(scene::make_frame(camera, aspect).proj_vk);
}

MovedPoints points_at_origin(std::size_t count, std::uint64_t seed) {
    MovedPoints all{.now = {.eye = {0.125, 1.5, 3.25}, .target = {0.5, 1.25, -1.0}},
                    .before = {.eye = {-0.0625, 1.5625, 3.375}, .target = {0.25, 1.25, -1.0}}};
    const glm::dvec2 p(projection_of(all.now)[0][0], projection_of(all.now)[1][1]);
    const glm::dmat3 rotation = scene::view_rotation(all.now);
    numeric::Random random(seed);
    while (all.points.size() < count) {
        const double depth = nearest * std::pow(farthest_move / nearest, random.unit());
        const glm::dvec2 ndc(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
        const glm::dvec3 at(ndc / p * depth, -depth);
        const glm::dvec3 point = on_grid(all.now.eye + glm::transpose(rotation) * at);
        if (seen(all.now, point) && seen(all.before, point)) all.points.push_back(point);
    }
    return all;
}

glm::dvec3 shift_by(double distance) {
    return std::round(distance / std::sqrt(3.0)) * glm::dvec3(1, -1, 1);
}

MovedPoints moved(MovedPoints all, double distance) {
    all.shift = shift_by(distance);
    for (scene::Camera* camera : {&all.now, &all.before}) {
        camera->eye += all.shift;
        camera->target += all.shift;
    }
    for (glm::dvec3& point : all.points) point += all.shift;
    return all;
}

scene::Scene moved_scene(const char* name, double distance) {
    const scene::Scene still = scene::make_scene(name);
    const glm::dvec3 shift = shift_by(distance);
    scene::Scene scene{.name = still.name, .camera = still.camera, .ao_radius = still.ao_radius};
    scene.camera.eye = on_grid(still.camera.eye) + shift;
    scene.camera.target = on_grid(still.camera.target) + shift;
    glm::dmat4 transform(1.0);
    transform[3] = glm::dvec4(shift, 1.0);
    scene.objects.push_back({.mesh = still.mesh, .transform = [transform](int) { return transform; }});
    return scene;
}

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
