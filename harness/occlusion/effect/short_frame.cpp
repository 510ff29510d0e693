// SPDX-License-Identifier: MIT
#include "effect/internal/short_frame.hpp"

#include <cmath>
#include <limits>

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

    // World units that are added to depth: an orthographic camera whose near plane is at the eye or behind it
    // has depths from 1 radius. No pass needs where its eye is.
    [[nodiscard]] double lift() const {
        if (!encoding.depth_buffer || !view.camera.orthographic()) return 0.0;
        const double near = scene::planes_of(view.camera.proj_vk).near;
        return near <= 0.0 ? radius - near : 0.0;
    }
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

// Push constants, with the layout that each pass declares.
struct PrepareParameters {
    glm::mat4 before;  // as mat4x3
    glm::vec2 numerator;
    glm::vec2 divisor;
    glm::vec2 inverse_size;
    float far;
};
struct SweepParameters {
    glm::mat3x4 view_from_world;
    glm::vec2 inverse_span;
    glm::vec2 first;
    glm::vec2 span;
    glm::vec2 ray_span;
    glm::vec2 first_ray;
    glm::vec2 reach;
    glm::vec2 numerator;
    glm::vec2 divisor;
    glm::vec2 noise;
    float far;
};
struct HistoryParameters {
    glm::mat4 before;  // as mat4x3
    float most;
    float range;
    float narrowing;
    float sharpness;
    float dither;
    std::array<float, 3> padding{};  // to a multiple of 16 bytes
};
struct FilterParameters {
    HistoryParameters history;
    glm::vec2 inverse_size;
};
struct JoinParameters {
    HistoryParameters history;
    glm::vec2 inverse_half_size;
    glm::vec2 inverse_size;
};

// From (column, row, 1, 1 / depth) of a pixel, orthographic (column, row, 1, depth), to view space over depth
// or, orthographic, to view space, both in radii.
glm::dmat4 view_from_pixel(const Taken& taken) {
    const View& view = taken.view;
    const double radius = taken.radius;
    const glm::dvec2 scale = view.camera.p00_p11();
    const bool orthographic = view.camera.orthographic();
    const glm::dvec2 step = 2.0 / (glm::dvec2(view.extent.width, view.extent.height) * scale);
    const glm::dvec2 axis(view.camera.proj_vk[orthographic ? 3 : 2]);
    const glm::dvec2 first = ((orthographic ? -axis : axis) - 1.0) / scale + 0.5 * step;
    const double unit = orthographic ? radius : 1.0;
    glm::dmat4 matrix(0.0);
    matrix[0][0] = step.x / unit;
    matrix[1][1] = step.y / unit;
    matrix[2] = {first / unit, orthographic ? taken.lift() / radius : -1.0, orthographic ? 1.0 : 0.0};
    matrix[3] = {0.0, 0.0, orthographic ? -1.0 : 0.0, orthographic ? 0.0 : 1.0};
    return matrix;
}

// What gloam_frame_before() takes.
glm::mat4 pixel_before(const Taken& taken, const Before& before) {
    const View& view = taken.view;
    glm::dmat4 motion(1.0);
    if (!before.still) motion = view.camera.previous_from_current.value_or(glm::mat4(1.0F));
    motion[3] = {glm::dvec3(motion[3]) / double{taken.radius}, 1.0};
    const glm::dmat4 pixel = glm::inverse(view_from_pixel(before.taken)) * motion * view_from_pixel(taken);
    // Column, row, 1 and 1 / depth, times the depth before; orthographic: the last is the depth.
    const glm::dmat4 rows = glm::transpose(pixel);
    const glm::dvec4 one = rows[2];
    const glm::dvec2 size(view.extent.width, view.extent.height);
    glm::dmat4 all(0.0);
    all[0] = (rows[0] + 0.5 * one) / size.x;
    all[1] = (rows[1] + 0.5 * one) / size.y;
    all[2] = view.camera.orthographic() ? rows[3] : one;
    return glm::mat4(glm::transpose(all));
}

bool is_half(const Settings& settings) {
    return settings.resolution == Resolution::half;
}

double part_of(double value) {
    return value - std::floor(value);
}

HistoryParameters history_parameters(const Settings& settings, const Taken& taken, const Before& before) {
    constexpr float unit = 1.0F / 1023.0F;
    constexpr float range_moved = 0.01F;
    const float range = before.still ? 1.0F : settings.history_range;
    return {.before = pixel_before(taken, before),
            .most = before.known ? unit * (before.still ? 63.0F : 7.0F) : 0.0F,
            .range = range,
            .narrowing = range - range_moved,
            .sharpness = before.still ? 0.0F : settings.history_sharpness,
            .dither = static_cast<float>(part_of(before.frames * 0.4142136))};
}

// Depth in radii, as gloam_level_depth() has it.
PrepareParameters prepare_parameters(const Taken& taken, const Before& before) {
    const View& view = taken.view;
    const double radius = taken.radius;
    const double p22 = view.camera.proj_vk[2][2];
    const double p32 = view.camera.proj_vk[3][2];
    const bool orthographic = view.camera.orthographic();
    PrepareParameters all{.before = pixel_before(taken, before),
                          .numerator = {0.0, 1.0 / radius},
                          .divisor = {1.0, 0.0},
                          .inverse_size = 1.0F / glm::vec2(view.extent.width, view.extent.height),
                          .far = std::numeric_limits<float>::infinity()};
    if (!taken.encoding.depth_buffer) return all;
    all.far = scene::planes_of(view.camera.proj_vk).reversed_z ? 0.0F : 1.0F;
    all.numerator = orthographic ? glm::dvec2(p32 + taken.lift() * p22, -1.0) / (p22 * radius)
                                 : glm::dvec2(p32 / radius, 0.0);
    if (!orthographic) all.divisor = {p22, 1.0};
    return all;
}

SweepParameters sweep_parameters(const Taken& taken, const PrepareParameters& depth, int frames) {
    const View& view = taken.view;
    const glm::vec2 size(view.extent.width, view.extent.height);
    const glm::vec2 scale = view.camera.p00_p11();
    const float unit = view.camera.orthographic() ? taken.radius : 1.0F;
    const glm::vec2 step = 2.0F / (size * scale);
    const glm::vec2 last = glm::max(size - 1.0F, 1.0F);
    return {.view_from_world = glm::mat3x4(glm::mat3(view.camera.view)),
            .inverse_span = 1.0F / last,
            .first = 0.5F / size,
            .span = last / size,
            .ray_span = step * last / unit,
            .first_ray = (glm::vec2(view.camera.proj_vk[2]) - 1.0F) / scale + 0.5F * step,
            .reach = unit / step,
            .numerator = depth.numerator,
            .divisor = depth.divisor,
            .noise = {part_of(frames * 0.6180340), part_of(frames * 0.7548777)},
            .far = depth.far};
}

// Groups of 16 x 8 invocations, which make `x` x `y` pixels each.
std::array<std::uint32_t, 3> groups_of(gpu::Extent extent, std::uint32_t x, std::uint32_t y) {
    return {(extent.width + 16 * x - 1) / (16 * x), (extent.height + 8 * y - 1) / (8 * y), 1};
}

gpu::SpecializationConstant history_constant(const Settings& settings) {
    return {.id = 8, .bits = flag(settings.history)};
}

PlannedPass first_pass(const Settings& settings, const View& view, const PrepareParameters& depth) {
    const PassSource source{
        .file = "frame/prepare.comp",
        .constants = {{.id = 1, .bits = flag(view.camera.orthographic())}, history_constant(settings)}};
    return single_pass("prepare", source,
                       {"depth", "levels/0", "levels/1", "levels/2", "levels/3", "levels/4",
                        settings.history ? "levels_before" : nothing_image},
                       depth, groups_of(view.extent, 2, 2));
}

PlannedPass last_pass(const Settings& settings, const Taken& taken, const Before& before) {
    const View& view = taken.view;
    const glm::vec2 size(view.extent.width, view.extent.height);
    PassSource source{
        .file = is_half(settings) ? "frame/join.comp" : "frame/filter.comp",
        .constants = {{.id = 1, .bits = flag(view.camera.orthographic())}, history_constant(settings)},
        .unrolls = true};
    define_output(settings.output, source.defines);
    std::vector<std::string> resources{"texels", "shown"};
    if (is_half(settings)) resources.insert(resources.begin() + 1, "levels");
    for (const char* name : {"history_before/linear", "levels_before", "history"})
        resources.emplace_back(settings.history ? name : nothing_image);
    const HistoryParameters history = history_parameters(settings, taken, before);
    if (is_half(settings)) {
        const gpu::Extent half = half_of(view.extent);
        const JoinParameters all{history, 1.0F / glm::vec2(half.width, half.height), 1.0F / size};
        return single_pass("join", source, std::move(resources), all, groups_of(view.extent, 2, 2));
    }
    source.constants.push_back({.id = 0, .bits = static_cast<std::uint32_t>(settings.filter_half_width)});
    const FilterParameters all{history, 1.0F / size};
    return single_pass("filter", source, std::move(resources), all, groups_of(view.extent, 2, 1));
}

std::vector<PlannedPass> passes_of(const Settings& settings, const Taken& taken, const Before& before) {
    const View& view = taken.view;
    const PrepareParameters depth = prepare_parameters(taken, before);
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
    return {first_pass(settings, view, depth),
            single_pass("sweep", sweep, {"levels", taken.normals ? "normal" : "depth", "texels"},
                        sweep_parameters(taken, depth, before.frames),
                        groups_of(is_half(settings) ? half_of(view.extent) : view.extent, 1, 1)),
            last_pass(settings, taken, before)};
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
