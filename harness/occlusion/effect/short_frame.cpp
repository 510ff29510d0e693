// SPDX-License-Identifier: MIT
#include "effect/short_frame.hpp"

#include <fmt/format.h>
#include <passes/frame/gloam_frame.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "effect/internal/executor.hpp"
#include "effect/internal/frame.hpp"
#include "effect/internal/frame_images.hpp"
#include "effect/internal/named.hpp"

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
gloam_frame filled(const ShortSettings& settings, const Taken& taken, const Before& before) {
    const View& view = taken.view;
    const gpu::Extent extent = view.extent;
    gloam_frame frame{.settings = {.preset = {settings.half, settings.range, settings.sharpness},
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

gpu::SpecializationConstant history_constant(const ShortSettings& settings) {
    return {.id = 8, .bits = flag(settings.history)};
}

PlannedPass first_pass(const ShortSettings& settings, const View& view, const gloam_prepare& parameters) {
    const PassSource source{
        .file = "frame/prepare.comp",
        .constants = {{.id = 1, .bits = flag(view.camera.orthographic())}, history_constant(settings)}};
    return single_pass("prepare", source,
                       {"depth", "levels/0", "levels/1", "levels/2", "levels/3", "levels/4",
                        settings.history ? "levels_before" : nothing_image},
                       parameters, groups_of(view.extent, 2, 2));
}

PlannedPass last_pass(const ShortSettings& settings, const View& view, const gloam_last& parameters) {
    PassSource source{
        .file = settings.half ? "frame/join.comp" : "frame/filter.comp",
        .constants = {{.id = 1, .bits = flag(view.camera.orthographic())}, history_constant(settings)},
        .unrolls = true};
    define_output(settings.output, source.defines);
    std::vector<std::string> resources{"texels", "shown"};
    if (settings.half) resources.insert(resources.begin() + 1, "levels");
    for (const char* name : {"history_before/linear", "levels_before", "history"})
        resources.emplace_back(settings.history ? name : nothing_image);
    if (settings.half)
        return single_pass("join", source, std::move(resources), parameters, groups_of(view.extent, 2, 2));
    source.constants.push_back({.id = 0, .bits = settings.half_width});
    PlannedPass filter =
        single_pass("filter", source, std::move(resources), parameters, groups_of(view.extent, 2, 1));
    filter.parameters.resize(offsetof(gloam_last, inverse_size));
    return filter;
}

std::vector<PlannedPass> passes_of(const ShortSettings& settings, const Taken& taken, const Before& before) {
    const View& view = taken.view;
    const gloam_frame frame = filled(settings, taken, before);
    const PassSource sweep{.file = "frame/sweep.comp",
                           .constants = {{.id = 1, .bits = flag(view.camera.orthographic())},
                                         {.id = 2, .bits = flag(taken.encoding.world)},
                                         {.id = 3, .bits = flag(taken.encoding.octahedral)},
                                         {.id = 4, .bits = flag(taken.encoding.unorm)},
                                         {.id = 5, .bits = settings.slices},
                                         {.id = 6, .bits = settings.steps},
                                         {.id = 7, .bits = settings.half ? 2U : 1U},
                                         history_constant(settings),
                                         {.id = 9, .bits = flag(!taken.normals)}},
                           .unrolls = settings.slices < 4};
    return {first_pass(settings, view, frame.prepare),
            single_pass("sweep", sweep, {"levels", taken.normals ? "normal" : "depth", "texels"}, frame.sweep,
                        groups_of(settings.half ? half_of(view.extent) : view.extent, 1, 1)),
            last_pass(settings, view, frame.last)};
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

Plan short_plan(const ShortSettings& settings, const Taken& taken, const Before& before) {
    const View& view = taken.view;
    const gpu::Extent swept = settings.half ? half_of(view.extent) : view.extent;
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

const std::vector<ShortSettings>& short_frames() {
    static const std::vector<ShortSettings> all{
        {.name = "frame-fast", .slices = 1, .steps = 6, .half = true, .range = 0.15F, .sharpness = 0.3F},
        {.name = "frame-balanced", .slices = 2, .steps = 8, .half = true, .range = 0.08F, .sharpness = 0.9F},
        {.name = "frame-quality",
         .slices = 1,
         .steps = 7,
         .half_width = 2,
         .range = 0.05F,
         .sharpness = 1.0F},
        {.name = "frame-reference", .slices = 2, .steps = 9, .range = 0.03F, .sharpness = 1.0F}};
    return all;
}

const ShortSettings& short_frame_named(std::string_view name) {
    return named(short_frames(), name, "frame");
}

Plan plan_of(const ShortSettings& settings, const PlanOptions& options) {
    const Taken taken{view_of(options), 1.0F, options.encoding, options.normals};
    Plan plan = short_plan(settings, taken, {.taken = taken, .known = true});
    for (PlannedImage& image : plan.images)
        if (image.name == "normal" && options.encoding.unorm) image.format = rgba8;
    return plan;
}

Plan plan_of(const ShortSettings& settings, const scene::GBuffer& view, float radius) {
    const Taken taken = taken_of(view, radius);
    return short_plan(settings, taken, {.taken = taken});
}

struct ShortFrame::Impl {
    Impl(const gpu::Device& the_device, const scene::PassLibrary& passes)
        : device(&the_device), executor(the_device, passes), resources(the_device) {}

    const gpu::Device* device;
    Executor executor;
    Resources resources;
    Before before;           // what the next frame has before it, unless a cut comes
    ShortSettings settings;  // of these frames

    // What a view that follows has before it.
    [[nodiscard]] Before before_of(const Taken& taken, const ShortSettings& next) const;
    [[nodiscard]] Frame frame(const scene::GBuffer& view, const ShortSettings& of, float radius, int repeat);
};

Before ShortFrame::Impl::before_of(const Taken& taken, const ShortSettings& next) const {
    const View& view = taken.view;
    const scene::CameraFrame& camera = view.camera;
    const View& given = before.taken.view;
    const scene::CameraFrame& last = given.camera;
    const scene::GBuffer now{.extent = view.extent, .camera = camera, .border = view.border};
    const scene::GBuffer then{.extent = given.extent, .camera = last, .border = given.border};
    Before found = before;
    found.still = camera.view == last.view && camera.proj_vk == last.proj_vk && now.extent == then.extent;
    const bool follows = found.still || (cut_between(then, now).empty() && camera.previous_from_current);
    found.known = before.known && next == settings && taken.radius == before.taken.radius && follows &&
                  camera.orthographic() == last.orthographic();
    return found.known ? found : Before{.taken = taken};
}

Frame ShortFrame::Impl::frame(const scene::GBuffer& view, const ShortSettings& of, float radius, int repeat) {
    if (!(radius > 0.0F && std::isfinite(radius)))
        throw std::invalid_argument(fmt::format("radius {:g}: expected more than 0", radius));
    require_sizes(view, view.extent);
    const Taken taken = taken_of(view, radius);
    const Before there = of.history ? before_of(taken, of) : Before{.taken = taken};
    const Plan plan = short_plan(of, taken, there);
    resources.provide(plan);
    upload(view, view.extent, true, resources);
    const std::vector<Step> steps = executor.steps(plan.passes, resources);
    Frame frame;
    frame.times = effect::run(*device, steps, {}, repeat);
    frame.extent = scene::frame_of(view);
    frame.filtered = frame.occlusion = scene::cropped(view, resources.image("shown").download());
    frame.memory_bytes = memory_of(steps);
    resources.exchange(plan.exchanged);
    before = {.taken = taken, .frames = there.frames + 1, .known = of.history};
    settings = of;
    return frame;
}

ShortFrame::ShortFrame(const gpu::Device& device, const scene::PassLibrary& passes)
    : impl_(base::make_hidden<Impl>(device, passes)) {}

Frame ShortFrame::run(const scene::GBuffer& view, const ShortSettings& settings, float radius, int repeat) {
    return impl_->frame(view, settings, radius, repeat);
}

void ShortFrame::cut() {
    impl_->before.known = false;
}

}  // namespace gloam::effect
