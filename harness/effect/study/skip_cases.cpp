// SPDX-License-Identifier: MIT
#include "effect/study/skip_cases.hpp"

#include "effect/presets.hpp"
#include "scene/primitives.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect {
namespace {

constexpr int frames = 8;

// A mean of few samples, so that a view settles in few frames; what a settled view costs is not theirs to
// say.
constexpr float few_samples = 64.0F;
constexpr int settled_after = 64;

// A square floor that fills most of the view of a camera that walks over it.
scene::Scene floor_scene() {
    scene::Scene scene{.name = "floor",
                       .mesh = scene::make_parallelogram({-40, 0, -60}, {0, 0, 70}, {80, 0, 0}, 1.0)};
    scene.camera = {.eye = {0, 1.7, 0}, .target = {0, 0, -3.0}, .fovy_rad = 0.9, .near = 0.1, .far = 200.0};
    scene.camera_path = [start = scene.camera](int frame) {
        scene::Camera camera = start;
        camera.eye.z -= 0.02 * frame;
        camera.target.z -= 0.02 * frame;
        return camera;
    };
    return scene;
}

Settings settings_for(const scene::Scene& scene) {
    Settings settings = with_radius(preset_named("paper").settings, static_cast<float>(scene.ao_radius));
    settings.skip_background = settings.skip_open = settings.skip_settled = true;
    return settings;
}

}  // namespace

std::vector<SkipCase> skip_cases(const gpu::Device& device, const scene::PassLibrary& passes,
                                 gpu::Extent extent) {
    const auto moving = [&](const scene::Scene& scene, const char* what, bool objects, double target) {
        SkipCase made{.name = scene.name, .what = what, .settings = settings_for(scene), .target = target};
        for (int i = 0; i < frames; ++i)
            made.views.push_back(
                scene::rasterize(device, passes, scene, extent, {.frame = i, .motion = objects}));
        return made;
    };
    std::vector<SkipCase> cases{
        moving(scene::make_scene("sky"), "mostly sky, camera and a kite move", true, 0.25),
        moving(floor_scene(), "a wide floor, the camera moves", false, 0.35),
        moving(scene::make_scene("far"), "a terrace with balls, the camera moves", false, 0.35),
        moving(scene::make_scene("grass"), "nothing to skip, the camera moves", false, 1.03)};
    const scene::Scene columns = scene::make_scene("columns");
    SkipCase still{.name = columns.name,
                   .what = "a view that stands still, settled",
                   .views = {scene::rasterize(device, passes, columns, extent)},
                   .warm = settled_after,
                   .settings = settings_for(columns),
                   .target = 0.1};
    still.settings.freeze = true;
    still.settings.weight_max = few_samples;
    cases.push_back(std::move(still));
    return cases;
}

}  // namespace gloam::effect
