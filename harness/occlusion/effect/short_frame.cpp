// SPDX-License-Identifier: MIT
#include "effect/internal/short_frame.hpp"

#include <passes/frame/gloam_frame.h>

#include <algorithm>
#include <cstddef>

#include "effect/internal/executor.hpp"
#include "effect/internal/frame.hpp"
#include "effect/internal/frame_images.hpp"

namespace gloam::effect {

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

namespace {

using enum gpu::Format;

constexpr std::uint32_t depth_levels = 5;

bool is_half(const Settings& settings) {
    return settings.resolution == Resolution::half;
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
    return single_pass("filter", source, std::move(resources), parameters, groups_of(view.extent, 2, 1));
}

PlannedPass sweep_pass(const Settings& settings, const Taken& taken, const gloam_sweep& parameters) {
    const gpu::Extent extent = taken.view.extent;
    PassSource source{.file = "frame/sweep.comp",
                      .constants = {{.id = 1, .bits = flag(taken.view.camera.orthographic())},
                                    {.id = 2, .bits = flag(taken.encoding.world)},
                                    {.id = 3, .bits = flag(taken.encoding.octahedral)},
                                    {.id = 4, .bits = flag(taken.encoding.unorm)},
                                    {.id = 5, .bits = slices_of(settings)},
                                    {.id = 6, .bits = settings.own.steps},
                                    {.id = 7, .bits = is_half(settings) ? 2U : 1U},
                                    history_constant(settings)},
                      .unrolls = slices_of(settings) < 4};
    if (!taken.normals) source.defines.emplace_back("GLOAM_NORMALS_FROM_DEPTH");
    PlannedPass sweep =
        single_pass("sweep", source, {"levels", taken.normals ? "normal" : "depth", "texels"}, parameters,
                    groups_of(is_half(settings) ? half_of(extent) : extent, 1, 1));
    if (taken.normals) sweep.parameters.resize(offsetof(gloam_sweep, depth));
    return sweep;
}

std::vector<PlannedPass> passes_of(const Settings& settings, const Taken& taken, const Before& before) {
    const gloam_frame frame = filled(settings, taken, before);
    return {first_pass(settings, taken.view, frame.prepare), sweep_pass(settings, taken, frame.sweep),
            last_pass(settings, taken.view, frame.last)};
}

void add_history(gpu::Extent extent, Plan& plan) {
    using Origin = PlannedImage::Origin;
    plan.images.push_back({.name = "levels_before",
                           .meaning = "levels of the frame before",
                           .format = r16f,
                           .origin = Origin::history,
                           .extent = extent,
                           .levels = depth_levels});
    plan.images.push_back({.name = "history_before",
                           .meaning = "the history of the frame before",
                           .format = rgb10_a2,
                           .origin = Origin::history,
                           .extent = extent});
    plan.images.push_back(
        {.name = "history", .meaning = "the history of this frame", .format = rgb10_a2, .extent = extent});
    plan.exchanged = {{"levels_before", "levels"}, {"history_before", "history"}};
}

Plan short_plan(const Settings& settings, const Taken& taken, const Before& before) {
    const View& view = taken.view;
    const gpu::Extent swept = is_half(settings) ? half_of(view.extent) : view.extent;
    Plan plan;
    plan.images = {{.name = "depth",
                    .meaning = "depth as the engine stores it",
                    .format = r32f,
                    .origin = PlannedImage::Origin::engine,
                    .extent = view.extent},
                   {.name = "normal",
                    .meaning = "normals as the engine stores them",
                    .format = rgba32f,
                    .origin = PlannedImage::Origin::engine,
                    .extent = view.extent},
                   {.name = "levels",
                    .meaning = "eye-linear depth in radii",
                    .format = r16f,
                    .extent = view.extent,
                    .levels = depth_levels},
                   {.name = "texels",
                    .meaning = "what the sweep finds (gloam/filter/frame_texel.glsl)",
                    .format = r32ui,
                    .extent = swept},
                   {.name = "shown",
                    .meaning = "the occlusion",
                    .format = format_of(settings.output),
                    .extent = view.extent}};
    if (settings.history) add_history(view.extent, plan);
    if (!taken.normals)
        std::erase_if(plan.images, [](const PlannedImage& image) { return image.name == "normal"; });
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

}  // namespace

Plan frame_plan(const Settings& settings, const PlanOptions& options) {
    const Taken taken{view_of(options), 1.0F, options.encoding, options.normals};
    Plan plan = short_plan(settings, taken, {.taken = taken, .known = true});
    for (PlannedImage& image : plan.images)
        if (image.name == "normal" && options.encoding.unorm) image.format = rgba8;
    return plan;
}

Plan frame_plan(const Settings& settings, const scene::GBuffer& view) {
    const Taken taken = taken_of(view, settings.radius);
    return short_plan(settings, taken, {.taken = taken});
}

struct ShortFrame::Impl {
    Impl(const gpu::Device& the_device, const scene::PassLibrary& passes)
        : device(&the_device), executor(the_device, passes), resources(the_device) {}

    const gpu::Device* device;
    Executor executor;
    Resources resources;
    Settings settings;
    Taken taken;
    Before before;  // what the next frame has before it

    // What this view has before it.
    [[nodiscard]] Before before_of_view() const;
};

Before ShortFrame::Impl::before_of_view() const {
    const View& view = taken.view;
    const scene::CameraFrame& camera = view.camera;
    const View& given = before.taken.view;
    const scene::CameraFrame& last = given.camera;
    const scene::GBuffer now{.extent = view.extent, .camera = camera, .border = view.border};
    const scene::GBuffer then{.extent = given.extent, .camera = last, .border = given.border};
    Before found = before;
    found.still = camera.view == last.view && camera.proj_vk == last.proj_vk && now.extent == then.extent;
    const bool follows = found.still || (cut_between(then, now).empty() && camera.previous_from_current);
    found.known = before.known && follows && camera.orthographic() == last.orthographic();
    return found.known ? found : Before{.taken = taken};
}

ShortFrame::ShortFrame(const gpu::Device& device, const scene::PassLibrary& passes)
    : impl_(base::make_hidden<Impl>(device, passes)) {}

void ShortFrame::take(const scene::GBuffer& view, const Settings& settings, bool follows) {
    Impl& impl = *impl_;
    require_sizes(view, view.extent);
    (void)scene::frame_of(view);
    impl.before.known = impl.before.known && follows;
    impl.settings = settings;
    impl.taken = taken_of(view, settings.radius);
    impl.resources.provide(frame_plan(settings, view));
    upload(view, view.extent, true, impl.resources);
}

Frame ShortFrame::next(int repeat, const PassWatcher& watcher) {
    Impl& impl = *impl_;
    const Before there = impl.settings.history ? impl.before_of_view() : Before{.taken = impl.taken};
    const Plan plan = short_plan(impl.settings, impl.taken, there);
    const std::vector<Step> steps = impl.executor.steps(plan.passes, impl.resources);
    Frame frame;
    frame.times = run(*impl.device, steps, {}, repeat, watcher);
    const View& view = impl.taken.view;
    const scene::GBuffer shape{.extent = view.extent, .border = view.border};
    frame.extent = scene::frame_of(shape);
    frame.filtered = frame.occlusion = scene::cropped(shape, impl.resources.image("shown").download());
    frame.memory_bytes = memory_of(steps);
    impl.resources.exchange(plan.exchanged);
    impl.before = {.taken = impl.taken, .frames = there.frames + 1, .known = impl.settings.history};
    return frame;
}

}  // namespace gloam::effect
