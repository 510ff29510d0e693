// SPDX-License-Identifier: MIT
#include "effect/study/skip_cases.hpp"

#include "effect/methods.hpp"
#include "effect/presets.hpp"
#include "effect/study/skip_floor.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect {
namespace {

constexpr int case_frames = 8;

// A mean of few samples, so that a view settles in few frames. The cost of a settled view does not depend on
// it.
constexpr float few_samples = 64.0F;
constexpr int settled_after = 64;

Settings with_skips(const scene::Scene& scene) {
    Settings settings = with_radius(preset_named("paper").settings, static_cast<float>(scene.ao_radius));
    settings.skip_background = settings.skip_open = settings.skip_closed = settings.skip_settled =
        settings.skip_filtered = true;
    return settings;
}

}  // namespace

std::vector<SkipCase> skip_cases(const gpu::Device& device, const scene::PassLibrary& passes,
                                 gpu::Extent extent) {
    const auto moving = [&](const scene::Scene& scene, const char* what, bool objects, double target) {
        SkipCase made{.name = scene.name, .what = what, .settings = with_skips(scene), .target = target};
        for (int i = 0; i < case_frames; ++i)
            made.views.push_back(
                scene::rasterize(device, passes, scene, extent, {.frame = i, .motion = objects}));
        return made;
    };
    std::vector<SkipCase> cases{
        moving(scene::make_scene("sky"), "mostly sky, camera and a kite move", true, 0.25),
        moving(skip_floor(), "a wide floor, the camera moves", false, 0.35),
        moving(scene::make_scene("far"), "a terrace with balls, the camera moves", false, 0.0),
        moving(scene::make_scene("grass"), "grass under a sky, the camera moves", false, 1.03)};
    const scene::Scene columns = scene::make_scene("columns");
    SkipCase still{.name = columns.name,
                   .what = "a view that stands still, settled",
                   .views = {scene::rasterize(device, passes, columns, extent)},
                   .warm = settled_after,
                   .settings = with_skips(columns),
                   .target = 0.1};
    still.settings.freeze = true;
    still.settings.weight_max = few_samples;
    cases.push_back(std::move(still));
    for (const char* method : {"bitmask", "hbao"}) {
        cases.push_back(moving(scene::make_scene("far"), method, false, 0.0));
        cases.back().settings = with_method(cases.back().settings, method);
    }
    return cases;
}

}  // namespace gloam::effect
