// SPDX-License-Identifier: MIT
#include "effect/short_frame.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "effect/internal/executor.hpp"
#include "effect/internal/frame.hpp"
#include "effect/internal/frame_images.hpp"
#include "effect/internal/named.hpp"

namespace gloam::effect {
namespace {

using enum gpu::Format;

constexpr std::uint32_t depth_levels = 5;

// Push constants, with the layout that each pass declares.
struct PrepareParameters {
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
    float far;
};
struct FilterParameters {
    glm::vec2 inverse_size;
};
struct JoinParameters {
    glm::vec2 inverse_half_size;
    glm::vec2 inverse_size;
};

// Depth in radii, as gloam_level_depth() has it. An orthographic camera whose near plane is at the eye or
// behind it has depths from 1 radius: no pass needs where its eye is.
PrepareParameters prepare_parameters(const View& view, float radius, bool depth_buffer) {
    const double p22 = view.camera.proj_vk[2][2];
    const double p32 = view.camera.proj_vk[3][2];
    const bool orthographic = view.camera.orthographic();
    PrepareParameters all{.numerator = {0.0, 1.0 / radius},
                          .divisor = {1.0, 0.0},
                          .inverse_size = 1.0F / glm::vec2(view.extent.width, view.extent.height),
                          .far = std::numeric_limits<float>::infinity()};
    if (!depth_buffer) return all;
    const scene::Planes planes = scene::planes_of(view.camera.proj_vk);
    const double before = orthographic && planes.near <= 0.0 ? radius - planes.near : 0.0;
    all.far = planes.reversed_z ? 0.0F : 1.0F;
    all.numerator =
        orthographic ? glm::dvec2(p32 + before * p22, -1.0) / (p22 * radius) : glm::dvec2(p32 / radius, 0.0);
    if (!orthographic) all.divisor = {p22, 1.0};
    return all;
}

SweepParameters sweep_parameters(const View& view, float radius, const PrepareParameters& depth) {
    const glm::vec2 size(view.extent.width, view.extent.height);
    const glm::vec2 scale = view.camera.p00_p11();
    const float unit = view.camera.orthographic() ? radius : 1.0F;
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
            .far = depth.far};
}

// Groups of 16 x 8 invocations, which make `x` x `y` pixels each.
std::array<std::uint32_t, 3> groups_of(gpu::Extent extent, std::uint32_t x, std::uint32_t y) {
    return {(extent.width + 16 * x - 1) / (16 * x), (extent.height + 8 * y - 1) / (8 * y), 1};
}

PlannedPass last_pass(const ShortSettings& settings, gpu::Extent extent) {
    const glm::vec2 size(extent.width, extent.height);
    PassSource source{.file = settings.half ? "frame/join.comp" : "frame/filter.comp", .unrolls = true};
    define_output(settings.output, source.defines);
    if (settings.half) {
        const gpu::Extent half = half_of(extent);
        const JoinParameters all{1.0F / glm::vec2(half.width, half.height), 1.0F / size};
        return single_pass("join", source, {"texels", "levels", "shown"}, all, groups_of(extent, 2, 2));
    }
    source.constants = {{.id = 0, .bits = settings.half_width}};
    const FilterParameters all{1.0F / size};
    return single_pass("filter", source, {"texels", "shown"}, all, groups_of(extent, 2, 1));
}

std::vector<PlannedPass> passes_of(const ShortSettings& settings, const View& view, float radius,
                                   const scene::Encoding& encoding, bool normals) {
    const gpu::Extent extent = view.extent;
    const PrepareParameters depth = prepare_parameters(view, radius, encoding.depth_buffer);
    const PassSource sweep{.file = "frame/sweep.comp",
                           .constants = {{.id = 1, .bits = flag(view.camera.orthographic())},
                                         {.id = 2, .bits = flag(encoding.world)},
                                         {.id = 3, .bits = flag(encoding.octahedral)},
                                         {.id = 4, .bits = flag(encoding.unorm)},
                                         {.id = 5, .bits = settings.slices},
                                         {.id = 6, .bits = settings.steps},
                                         {.id = 7, .bits = settings.half ? 2U : 1U},
                                         {.id = 8, .bits = flag(!normals)}},
                           .unrolls = true};
    return {single_pass("prepare", {.file = "frame/prepare.comp"},
                        {"depth", "levels/0", "levels/1", "levels/2", "levels/3", "levels/4"}, depth,
                        groups_of(extent, 2, 2)),
            single_pass("sweep", sweep, {"levels", normals ? "normal" : "depth", "texels"},
                        sweep_parameters(view, radius, depth),
                        groups_of(settings.half ? half_of(extent) : extent, 1, 1)),
            last_pass(settings, extent)};
}

Plan short_plan(const ShortSettings& settings, const View& view, float radius,
                const scene::Encoding& encoding, bool normals) {
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
    if (!normals)
        std::erase_if(plan.images, [](const PlannedImage& image) { return image.name == "normal"; });
    plan.passes = passes_of(settings, view, radius, encoding, normals);
    plan.result = "shown";
    return plan;
}

}  // namespace

const std::vector<ShortSettings>& short_frames() {
    static const std::vector<ShortSettings> all{
        {.name = "frame-fast", .slices = 1, .steps = 6, .half = true},
        {.name = "frame-balanced", .slices = 2, .steps = 8, .half = true},
        {.name = "frame-quality", .slices = 1, .steps = 7, .half_width = 2},
        {.name = "frame-reference", .slices = 2, .steps = 9}};
    return all;
}

const ShortSettings& short_frame_named(std::string_view name) {
    return named(short_frames(), name, "frame");
}

Plan plan_of(const ShortSettings& settings, const PlanOptions& options) {
    Plan plan = short_plan(settings, view_of(options), 1.0F, options.encoding, options.normals);
    for (PlannedImage& image : plan.images)
        if (image.name == "normal" && options.encoding.unorm) image.format = rgba8;
    return plan;
}

struct ShortFrame::Impl {
    Impl(const gpu::Device& the_device, const scene::PassLibrary& passes)
        : device(&the_device), executor(the_device, passes), resources(the_device) {}

    const gpu::Device* device;
    Executor executor;
    Resources resources;
};

ShortFrame::ShortFrame(const gpu::Device& device, const scene::PassLibrary& passes)
    : impl_(base::make_hidden<Impl>(device, passes)) {}

Frame ShortFrame::run(const scene::GBuffer& view, const ShortSettings& settings, float radius, int repeat) {
    if (!(radius > 0.0F && std::isfinite(radius)))
        throw std::invalid_argument(fmt::format("radius {:g}: expected more than 0", radius));
    require_sizes(view, view.extent);
    const Plan plan =
        short_plan(settings, {view.camera, view.extent, view.border}, radius,
                   view.stored ? view.stored->encoding : scene::Encoding{}, !view.normal.empty());
    impl_->resources.provide(plan);
    upload(view, view.extent, true, impl_->resources);
    const std::vector<Step> steps = impl_->executor.steps(plan.passes, impl_->resources);
    Frame frame;
    frame.times = effect::run(*impl_->device, steps, {}, repeat);
    frame.extent = scene::frame_of(view);
    frame.filtered = frame.occlusion = scene::cropped(view, impl_->resources.image("shown").download());
    frame.memory_bytes = memory_of(steps);
    return frame;
}

}  // namespace gloam::effect
