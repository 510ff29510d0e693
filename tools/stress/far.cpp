// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "base/half.hpp"
#include "effect/ambient_occlusion.hpp"
#include "effect/methods.hpp"
#include "judge/function.hpp"
#include "scene/draw.hpp"
#include "stress/run.hpp"

namespace gloam::stress {
namespace {

constexpr backend::Extent image{64, 36};
constexpr int frames = 4;
constexpr const char* rejected = "points that TSSAO-8 (0.01) rejects, %";
constexpr const char* bare = "occlusion of a bare wall (gtao)";

// StressCameras of shaders/far.glsl, member by member.
struct Cameras {
    glm::mat4 inverse_projection{1};
    glm::mat4 inverse_view{1};
    glm::mat4 previous_view{1};
    glm::mat4 previous_projection{1};
    glm::vec3 eye{0};
    glm::vec3 previous_eye{0};
};
using Previous = judge::Function<glm::vec3(glm::vec3, glm::vec4, float, Cameras, subject::Out<glm::vec4>,
                                           subject::Out<bool>)>;

// A scene and its moving camera, so far from the origin; moved by whole numbers, so that nothing is rounded.
scene::Scene scene_at(double distance) {
    const scene::Scene near = scene::make_scene("moving");
    const glm::dvec3 shift = std::round(distance / std::sqrt(3.0)) * glm::dvec3(1, -1, 1);
    scene::Scene far{.name = near.name, .mesh = {}, .camera = near.camera, .ao_radius = near.ao_radius};
    far.camera_path = [=](int frame) {
        scene::Camera camera = scene::camera_at(near, frame);
        for (glm::dvec3* at : {&camera.eye, &camera.target}) *at = glm::round(*at * 0x1p20) * 0x1p-20 + shift;
        return camera;
    };
    far.objects.push_back({near.mesh, [shift](int) { return glm::translate(glm::dmat4(1.0), shift); }});
    return far;
}

glm::dmat4 view_matrix(const scene::Camera& camera, const glm::dvec3& origin) {
    return glm::translate(glm::dmat4(scene::view_rotation(camera)), origin - camera.eye);
}

// The worst of all points.
struct Errors {
    double position = 0.0;  // parts of the distance from the eye
    double pixels = 0.0;    // of 1920 x 1080
    double rejected = 0.0;  // percent
};

// Reprojects the surfaces of a view, positions and matrices being relative to `origin`.
Errors reproject(const Previous& function, const scene::Scene& scene, const scene::GBuffer& view,
                 const glm::dvec3& origin, bool halves = false) {
    const scene::Camera now = scene::camera_at(scene, 1);
    const scene::Camera before = scene::camera_at(scene, 0);
    const glm::dmat4 projection(view.camera.proj_vk);
    const Cameras cameras{glm::mat4(glm::inverse(projection)),
                          glm::mat4(glm::inverse(view_matrix(now, origin))),
                          glm::mat4(view_matrix(before, origin)),
                          glm::mat4(projection),
                          glm::vec3(now.eye - origin),
                          glm::vec3(before.eye - origin)};
    std::vector<Previous::Inputs> inputs;
    std::vector<glm::dvec3> exact;  // relative to the eye before
    for (std::size_t i = 0; i < view.depth.size(); ++i) {
        const glm::dvec3 at = scene::PixelPositions(view).at(i, double{view.depth[i]});
        const glm::dvec3 from_eye = glm::transpose(scene::view_rotation(now)) * at;
        const glm::dvec3 previous = from_eye + (now.eye - before.eye);
        const auto depth = static_cast<float>(-(scene::view_rotation(before) * previous).z);
        exact.push_back(previous);
        inputs.emplace_back(glm::vec3(from_eye + (now.eye - origin)),
                            glm::vec4(projection * glm::dvec4(at, 1.0)),
                            halves ? base::from_half(base::to_half(depth)) : depth, cameras);
    }
    const std::vector<Previous::Output> outputs = function(inputs);
    Errors worst;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const auto& [position, clip, kept] = outputs[i];
        const glm::dvec4 right = projection * glm::dvec4(scene::view_rotation(before) * exact[i], 1.0);
        const glm::dvec2 off = glm::dvec2(clip) / double{clip.w} - glm::dvec2(right) / right.w;
        const double apart = glm::distance(glm::dvec3(position), exact[i]);
        worst.position = worse(worst.position, apart / glm::length(exact[i]));
        worst.pixels = worse(worst.pixels, glm::length(off * glm::dvec2(960.0, 540.0)));
        worst.rejected += kept ? 0.0 : 100.0 / static_cast<double>(outputs.size());
    }
    return worst;
}

// The occlusion after some frames of a moving camera. in_world: it moves as its matrices in float do.
std::vector<float> shown_after(effect::AmbientOcclusion& effect, const std::vector<scene::GBuffer>& views,
                               float radius, bool in_world) {
    effect.begin(views[0], effect::with_radius(effect::preset_named("balanced").settings, radius));
    effect::Frame frame = effect.next();
    for (std::size_t i = 1; i < views.size(); ++i) {
        scene::GBuffer view = views[i];
        if (in_world) {
            view.camera.previous_from_current.reset();
            scene::link(view, views[i - 1]);
        }
        effect.advance(view);
        frame = effect.next();
    }
    return frame.occlusion;
}

std::vector<scene::GBuffer> views_of(const scene::Scene& scene) {
    std::vector<scene::GBuffer> views;
    for (int i = 0; i < frames; ++i) views.push_back(scene::draw(scene, image, {.frame = i}));
    return views;
}

// The largest occlusion of a slanted wall whose depths are halves.
double wall_of_halves(effect::AmbientOcclusion& effect, float bias_depth) {
    scene::GBuffer view = wall(image, 0.5);
    for (float& depth : view.depth) depth = base::from_half(base::to_half(depth));
    effect::Settings settings =
        with_radius(with_method(effect::preset_named("tssao-paper").settings, "gtao"), 0.4F);
    settings.bias_depth = bias_depth;
    effect.begin(view, settings);
    return double{std::ranges::max(effect.next().occlusion)};
}

}  // namespace

void far_away(const Context& context) {
    const Previous previous(context.lab, "far.glsl", "stress_previous");
    effect::AmbientOcclusion effect(context.lab.device(), context.passes);
    const scene::Scene near = scene_at(0.0);
    const std::vector<scene::GBuffer> at_origin = views_of(near);
    const auto radius = static_cast<float>(near.ao_radius);
    const std::vector<float> expected = shown_after(effect, at_origin, radius, false);
    for (const double distance : {1e2, 1e3, 1e4, 1e5, 1e6, 1e7}) {
        const scene::Scene scene = scene_at(distance);
        const std::vector<scene::GBuffer> views = views_of(scene);
        const glm::dvec3 eye = scene::camera_at(scene, 1).eye;
        for (const bool world : {false, true}) {
            // Nothing is promised of what is relative to the world.
            const auto row = [&](const char* quantity, double measured, double bound) {
                context.add(fmt::format("{:.0e}, relative to the {}", distance, world ? "world" : "eye"),
                            quantity, measured, world ? std::nullopt : std::optional(bound));
            };
            const Errors errors = reproject(previous, scene, views[1], world ? glm::dvec3(0.0) : eye);
            const std::vector<float> shown = shown_after(effect, views, radius, world);
            // 1 ulp, and half a one of what is rounded before.
            row("position off, part of the distance", errors.position, 1.8e-7);
            // 1.2e-6 of the width (gloam_reproject_clip).
            row("reprojection off, pixels of 1920 x 1080", errors.pixels, 0.0023);
            row(rejected, errors.rejected, 0.0);
            const auto apart = [](float x, float y) { return std::abs(double{x} - double{y}); };
            row("occlusion off after 4 frames",
                std::transform_reduce(shown.begin(), shown.end(), expected.begin(), 0.0, worse, apart), 0.0);
        }
    }
    const glm::dvec3 eye = scene::camera_at(near, 1).eye;
    const double of_halves = reproject(previous, near, at_origin[1], eye, true).rejected;
    context.add("depth in halves", rejected, of_halves, 0.0);
    context.add("depth in halves, bias 0.001 radii", bare, wall_of_halves(effect, 0.0F), std::nullopt);
    context.add("depth in halves, bias_depth 0.002", bare, wall_of_halves(effect, 0.002F), 0.0);
}

}  // namespace gloam::stress
