// SPDX-License-Identifier: MIT
#include "effect/internal/frame.hpp"

#include <passes/frame/gloam_frame.h>

#include <algorithm>
#include <cstddef>

#include "effect/internal/executor.hpp"
#include "effect/internal/passes.hpp"
#include "effect/internal/study_frame.hpp"

namespace gloam::effect {
namespace {

using enum gpu::Format;

constexpr std::uint32_t depth_levels = 5;

// What a frame takes of the engine.
struct Taken {
    View view;
    float radius = 1.0F;
    scene::Encoding encoding{};
    bool normals = true;  // there are some
};

// And of the frame before.
struct Before {
    Taken taken;
    int frames = 0;      // of the sequence, before this one
    bool known = false;  // it has a history
    bool still = false;  // from the same camera
};

bool is_half(const Settings& settings) {
    return settings.resolution == Resolution::half;
}

// Of half of each side, rounded up.
gpu::Extent swept_of(const Settings& settings, gpu::Extent view) {
    return is_half(settings) ? gpu::Extent{(view.width + 1) / 2, (view.height + 1) / 2} : view;
}

void copy(const glm::mat4& matrix, float* numbers) {
    std::copy_n(&matrix[0][0], 16, numbers);
}

gloam_camera camera_of(const View& view) {
    gloam_camera camera{};
    copy(view.camera.proj_vk, camera.projection);
    copy(view.camera.view, camera.view);
    return camera;
}

// With what the passes are given.
gloam_frame filled(const Settings& settings, const Taken& taken, const Before& before) {
    const View& view = taken.view;
    const gpu::Extent extent = view.extent;
    const gloam_preset preset{is_half(settings), settings.history_range, settings.history_sharpness};
    gloam_frame frame{.settings = {.preset = preset,
                                   .size = {static_cast<int>(extent.width), static_cast<int>(extent.height)},
                                   .radius = taken.radius,
                                   .depth_buffer = taken.encoding.depth_buffer},
                      .now = camera_of(view),
                      .before = camera_of(before.taken.view),
                      .frames = before.frames,
                      .still = before.still};
    const bool moves = before.known && !before.still;
    copy(moves ? view.camera.previous_from_current.value_or(glm::mat4(1.0F)) : glm::mat4(1.0F),
         frame.previous_from_current);
    gloam_fill(&frame);
    return frame;
}

// Groups of 16 x 8 invocations, which make `x` x `y` pixels each.
std::array<std::uint32_t, 3> groups_of(gpu::Extent extent, std::uint32_t x, std::uint32_t y) {
    return {(extent.width + 16 * x - 1) / (16 * x), (extent.height + 8 * y - 1) / (8 * y), 1};
}

gpu::SpecializationConstant history_constant(const Settings& settings) {
    return {.id = 8, .bits = flag(settings.history)};
}

PlannedPass first_pass(const Settings& settings, const View& view, const gloam_prepare& parameters) {
    const PassSource source{
        .file = "frame/prepare.comp",
        .constants = {{.id = 1, .bits = flag(view.camera.orthographic())}, history_constant(settings)}};
    return single_pass("prepare", source,
                       {"depth", "levels/0", "levels/1", "levels/2", "levels/3", "levels/4",
                        settings.history ? "levels_before" : nothing_image},
                       parameters, groups_of(view.extent, 2, 2));
}

PlannedPass last_pass(const Settings& settings, const View& view, const gloam_last& parameters) {
    PassSource source{
        .file = is_half(settings) ? "frame/join.comp" : "frame/filter.comp",
        .constants = {{.id = 1, .bits = flag(view.camera.orthographic())}, history_constant(settings)},
        .unrolls = true};
    define_output(settings.output, source.defines);
    std::vector<std::string> resources{"texels", "shown"};
    if (is_half(settings)) resources.insert(resources.begin() + 1, "levels");
    for (const char* name : {"history_before/linear", "levels_before", "history"})
        resources.emplace_back(settings.history ? name : nothing_image);
    if (is_half(settings))
        return single_pass("join", source, std::move(resources), parameters, groups_of(view.extent, 2, 2));
    source.constants.push_back({.id = 0, .bits = static_cast<std::uint32_t>(settings.filter_half_width)});
    PlannedPass filter =
        single_pass("filter", source, std::move(resources), parameters, groups_of(view.extent, 2, 1));
    filter.parameters.resize(offsetof(gloam_last, inverse_size));
    return filter;
}

std::vector<PlannedPass> passes_of(const Settings& settings, const Taken& taken, const Before& before) {
    const View& view = taken.view;
    const gloam_frame frame = filled(settings, taken, before);
    const PassSource sweep{.file = "frame/sweep.comp",
                           .constants = {{.id = 1, .bits = flag(view.camera.orthographic())},
                                         {.id = 2, .bits = flag(taken.encoding.world)},
                                         {.id = 3, .bits = flag(taken.encoding.octahedral)},
                                         {.id = 4, .bits = flag(taken.encoding.unorm)},
                                         {.id = 5, .bits = slices_of(settings)},
                                         {.id = 6, .bits = settings.own.steps},
                                         {.id = 7, .bits = is_half(settings) ? 2U : 1U},
                                         history_constant(settings),
                                         {.id = 9, .bits = flag(!taken.normals)}},
                           .unrolls = slices_of(settings) < 4};
    return {first_pass(settings, view, frame.prepare),
            single_pass("sweep", sweep, {"levels", taken.normals ? "normal" : "depth", "texels"}, frame.sweep,
                        groups_of(swept_of(settings, view.extent), 1, 1)),
            last_pass(settings, view, frame.last)};
}

Plan plan_for(const Settings& settings, const Taken& taken, const Before& before) {
    using enum PlannedImage::Origin;
    const gpu::Extent extent = taken.view.extent;
    Plan plan;
    plan.images = {{"depth", r32f, engine, extent},                       // as it is stored
                   {"levels", r16f, frame, extent, depth_levels},         // eye-linear depth in radii
                   {"texels", r32ui, frame, swept_of(settings, extent)},  // gloam/filter/frame_texel.glsl
                   {"shown", format_of(settings.output), frame, extent}};
    if (taken.normals) plan.images.push_back({"normal", rgba32f, engine, extent});
    if (settings.history) {
        plan.images.push_back({"levels_before", r16f, history, extent, depth_levels});
        plan.images.push_back({"history_before", rgb10_a2, history, extent});
        plan.images.push_back({"history", rgb10_a2, frame, extent});
        plan.exchanged = {{"levels_before", "levels"}, {"history_before", "history"}};
    }
    plan.passes = passes_of(settings, taken, before);
    plan.result = "shown";
    return plan;
}

Taken taken_of(const scene::GBuffer& view, float radius) {
    return {{view.camera, view.extent, view.border},
            radius,
            view.stored ? view.stored->encoding : scene::Encoding{},
            !view.normal.empty()};
}

class ThreePasses : public FramePasses {
  public:
    ThreePasses(const gpu::Device& device, const scene::PassLibrary& passes)
        : device_(&device), executor_(device, passes), resources_(device) {}

    void take(const scene::GBuffer& view, const Settings& settings, bool follows) override {
        before_.known = before_.known && follows;
        settings_ = settings;
        taken_ = taken_of(view, settings.radius);
        resources_.provide(frame_plan(settings, view));
        upload(view, true, resources_);
    }

    [[nodiscard]] Frame next(int repeat, const PassWatcher& watcher) override {
        const Before there = settings_.history ? before_of_view() : Before{.taken = taken_};
        const Plan plan = plan_for(settings_, taken_, there);
        const std::vector<Step> steps = executor_.steps(plan.passes, resources_);
        Frame frame;
        frame.times = run(*device_, steps, repeat, watcher);
        frame.filtered = frame.occlusion = resources_.image("shown").download();
        crop({.extent = taken_.view.extent, .border = taken_.view.border}, frame);
        frame.memory_bytes = memory_of(steps);
        resources_.exchange(plan.exchanged);
        before_ = {.taken = taken_, .frames = there.frames + 1, .known = settings_.history};
        return frame;
    }

  private:
    [[nodiscard]] Before before_of_view() const;

    const gpu::Device* device_;
    Executor executor_;
    Resources resources_;
    Settings settings_;
    Taken taken_;
    Before before_;  // what the next frame has before it
};

// What this view has before it.
Before ThreePasses::before_of_view() const {
    const View& view = taken_.view;
    const scene::CameraFrame& camera = view.camera;
    const View& given = before_.taken.view;
    const scene::CameraFrame& last = given.camera;
    const scene::GBuffer now{.extent = view.extent, .camera = camera, .border = view.border};
    const scene::GBuffer then{.extent = given.extent, .camera = last, .border = given.border};
    Before found = before_;
    found.still = camera.view == last.view && camera.proj_vk == last.proj_vk && now.extent == then.extent;
    const bool follows = found.still || (cut_between(then, now).empty() && camera.previous_from_current);
    found.known = before_.known && follows && camera.orthographic() == last.orthographic();
    return found.known ? found : Before{.taken = taken_};
}

}  // namespace

Plan frame_plan(const Settings& settings, const PlanOptions& options) {
    const Taken taken{view_of(options), 1.0F, options.encoding, options.normals};
    Plan plan = plan_for(settings, taken, {.taken = taken, .known = true});
    for (PlannedImage& image : plan.images)
        if (image.name == "normal" && options.encoding.unorm) image.format = rgba8;
    return plan;
}

Plan frame_plan(const Settings& settings, const scene::GBuffer& view) {
    const Taken taken = taken_of(view, settings.radius);
    return plan_for(settings, taken, {.taken = taken});
}

std::unique_ptr<FramePasses> frame_passes(const gpu::Device& device, const scene::PassLibrary& passes) {
    return std::make_unique<ThreePasses>(device, passes);
}

}  // namespace gloam::effect
