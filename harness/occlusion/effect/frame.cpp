// SPDX-License-Identifier: MIT
#include "effect/internal/frame.hpp"

#include <fmt/format.h>
#include <passes/frame/gloam_frame.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <glm/gtc/packing.hpp>

#include "effect/internal/executor.hpp"
#include "effect/internal/passes.hpp"
#include "effect/internal/study_frame.hpp"

namespace gloam::effect {
namespace {

using enum gpu::Format;

constexpr std::uint32_t depth_levels = 5;
constexpr gpu::Extent tile{16, 8};          // texels that a group of the sweep makes
constexpr const char* tile_list = "tiles";  // glsl/passes/frame/tile_list.glsl

// What a frame takes of the engine.
struct Taken {
    View view;
    float radius = 1.0F;
    scene::Encoding encoding{};
    bool normals = true;  // there are some
    bool tiles = false;   // the sweep has a list of its tiles
    bool deep = false;    // depth has 32 bits: frame/parameters.glsl
};

// What tiles.comp is given.
struct TileParameters {
    std::array<float, 2> inverse_size;
    gpu::Extent count;
    std::uint32_t frame;
    std::uint32_t stands;
};

bool is_half(const Settings& settings) {
    return settings.resolution == Resolution::half;
}

// Of half of each side, rounded up.
gpu::Extent swept_of(const Settings& settings, gpu::Extent view) {
    return is_half(settings) ? gpu::Extent{(view.width + 1) / 2, (view.height + 1) / 2} : view;
}

gloam_camera camera_of(const View& view) {
    gloam_camera camera{};
    std::copy_n(&view.camera.proj_vk[0][0], 16, camera.projection);
    std::copy_n(&view.camera.view[0][0], 16, camera.view);
    return camera;
}

gloam_settings settings_of(const Settings& settings, const Taken& taken) {
    const gpu::Extent extent = taken.view.extent;
    return {.preset = {is_half(settings), settings.history_range, settings.history_sharpness,
                       taken.view.camera.orthographic(), taken.deep},
            .size = {static_cast<int>(extent.width), static_cast<int>(extent.height)},
            .radius = taken.radius,
            .depth_buffer = taken.encoding.depth_buffer};
}

// Whether depth of 16 bits is too coarse from the beginning.
bool starts_deep(const Settings& settings, const scene::CameraFrame& camera) {
    constexpr float narrow = 0.268F;  // tangent of half of 30 degrees, across the longer side of the image
    const glm::mat4& projection = camera.proj_vk;
    const float across = 1.0F / std::min(std::abs(projection[0][0]), std::abs(projection[1][1]));
    return settings.deep || camera.orthographic() || across < narrow;
}

// The first frame of a sequence.
gloam_frame first_of(const Settings& settings, const Taken& taken) {
    gloam_frame frame{};
    gloam_next(&frame, settings_of(settings, taken), camera_of(taken.view), nullptr);
    return frame;
}

// Groups of 16 x 8 invocations, which make `x` x `y` pixels each.
std::array<std::uint32_t, 3> groups_of(gpu::Extent extent, std::uint32_t x, std::uint32_t y) {
    return {(extent.width + 16 * x - 1) / (16 * x), (extent.height + 8 * y - 1) / (8 * y), 1};
}

// Those that all passes have, behind a pass' own.
std::vector<gpu::SpecializationConstant> constants_of(const Settings& settings, const Taken& taken,
                                                      std::vector<gpu::SpecializationConstant> own) {
    own.insert(own.end(), {{.id = 8, .bits = flag(settings.history)}, {.id = 9, .bits = flag(taken.deep)}});
    return own;
}

gpu::SpecializationConstant camera_constant(const Taken& taken) {
    return {.id = 1, .bits = flag(taken.view.camera.orthographic())};
}

PlannedPass first_pass(const Settings& settings, const Taken& taken, const gloam_prepare& parameters) {
    PassSource source{.file = "frame/prepare.comp",
                      .constants = constants_of(settings, taken, {camera_constant(taken)})};
    if (taken.deep) source.defines.emplace_back("GLOAM_LEVELS r32f");
    return single_pass("prepare", source,
                       {"depth", "levels/0", "levels/1", "levels/2", "levels/3", "levels/4",
                        settings.history ? "levels_before" : nothing_image},
                       parameters, groups_of(taken.view.extent, 2, 2));
}

PlannedPass last_pass(const Settings& settings, const Taken& taken, gloam_last parameters) {
    const gpu::Extent view = taken.view.extent;
    parameters.albedo = settings.bounce_albedo;
    PassSource source{.file = is_half(settings) ? "frame/join.comp" : "frame/filter.comp",
                      .constants = constants_of(settings, taken, {camera_constant(taken)}),
                      .unrolls = true};
    define_output(settings.output, source.defines);
    if (settings.bounce_albedo > 0.0F) source.defines.emplace_back("GLOAM_MULTI_BOUNCE");
    std::vector<std::string> resources{"texels", "shown"};
    if (is_half(settings)) resources.insert(resources.begin() + 1, "levels");
    for (const char* name : {"history_before/linear", "levels_before", "history"})
        resources.emplace_back(settings.history ? name : nothing_image);
    if (is_half(settings))
        return single_pass("join", source, std::move(resources), parameters, groups_of(view, 2, 2));
    source.constants.push_back({.id = 0, .bits = static_cast<std::uint32_t>(settings.filter_half_width)});
    return single_pass("filter", source, std::move(resources), parameters, groups_of(view, 2, 1));
}

PlannedPass sweep_pass(const Settings& settings, const Taken& taken, const gloam_sweep& parameters) {
    PassSource source{.file = "frame/sweep.comp",
                      .constants = constants_of(settings, taken,
                                                {camera_constant(taken),
                                                 {.id = 2, .bits = flag(taken.encoding.world)},
                                                 {.id = 3, .bits = flag(taken.encoding.octahedral)},
                                                 {.id = 4, .bits = flag(taken.encoding.unorm)},
                                                 {.id = 5, .bits = slices_of(settings)},
                                                 {.id = 6, .bits = settings.own.steps},
                                                 {.id = 7, .bits = is_half(settings) ? 2U : 1U}}),
                      .unrolls = slices_of(settings) < 4};
    if (taken.deep) source.defines.emplace_back("GLOAM_TEXELS rg32ui");
    if (!taken.normals) source.defines.emplace_back("GLOAM_NORMALS_FROM_DEPTH");
    PlannedPass sweep = single_pass("sweep", source, {"levels", taken.normals ? "normal" : "depth", "texels"},
                                    parameters, groups_of(swept_of(settings, taken.view.extent), 1, 1));
    if (taken.normals) sweep.parameters.resize(offsetof(gloam_sweep, depth));
    return sweep;
}

gpu::Extent tiles_of(const Settings& settings, gpu::Extent view) {
    const gpu::Extent swept = swept_of(settings, view);
    return {(swept.width + tile.width - 1) / tile.width, (swept.height + tile.height - 1) / tile.height};
}

PlannedPass tile_pass(const Settings& settings, const Taken& taken, const gloam_frame& frame) {
    const gpu::Extent count = tiles_of(settings, taken.view.extent);
    const TileParameters parameters{
        .inverse_size = {frame.prepare.inverse_size[0], frame.prepare.inverse_size[1]},
        .count = count,
        .frame = static_cast<std::uint32_t>(frame.frames),
        .stands = flag(frame.still != 0)};
    const PassSource source{
        .file = "frame/tiles.comp",
        .constants = constants_of(settings, taken, {{.id = 7, .bits = is_half(settings) ? 2U : 1U}})};
    return single_pass("tiles", source, {"levels", settings.history ? "levels_before" : nothing_image},
                       parameters, {(count.width + 7) / 8, count.height, 1});
}

// Binds the list of tiles behind the other resources of each pass.
void bind_tiles(std::vector<PlannedPass>& passes) {
    for (PlannedPass& pass : passes) {
        pass.source.defines.push_back(fmt::format("GLOAM_TILES {}", pass.resources.size()));
        pass.resources.emplace_back(tile_list);
    }
}

// Binds the images of bent normals behind the other resources.
void bind_bends(const Settings& settings, PlannedPass& sweep, PlannedPass& last) {
    for (PlannedPass* pass : {&sweep, &last}) {
        pass->source.defines.emplace_back("GLOAM_BENT_NORMALS");
        pass->resources.emplace_back("bends");
    }
    last.resources.emplace_back("bent");
    last.resources.emplace_back(settings.history ? "bent_before/linear" : nothing_image);
}

std::vector<PlannedPass> passes_of(const Settings& settings, const Taken& taken, const gloam_frame& frame) {
    std::vector<PlannedPass> passes{first_pass(settings, taken, frame.prepare),
                                    sweep_pass(settings, taken, frame.sweep),
                                    last_pass(settings, taken, frame.last)};
    if (settings.bent_normals) bind_bends(settings, passes[1], passes[2]);
    if (!taken.tiles) return passes;
    passes[1].groups_from = tile_list;
    passes.insert(passes.begin() + 1, tile_pass(settings, taken, frame));
    bind_tiles(passes);
    return passes;
}

Plan plan_for(const Settings& settings, const Taken& taken, const gloam_frame& numbers) {
    using enum PlannedImage::Origin;
    const gpu::Extent extent = taken.view.extent;
    const gpu::Format depths = taken.deep ? r32f : r16f;
    Plan plan;
    plan.images = {{"depth", r32f, engine, extent},                  // as it is stored
                   {"levels", depths, frame, extent, depth_levels},  // eye-linear depth in radii
                   {"texels", taken.deep ? rg32ui : r32ui, frame,
                    swept_of(settings, extent)},  // gloam/filter/frame_texel.glsl
                   {"shown", format_of(settings.output), frame, extent}};
    if (taken.normals) plan.images.push_back({"normal", rgba32f, engine, extent});
    if (settings.bent_normals)
        plan.images.insert(plan.images.end(), {{"bends", rgba8, frame, swept_of(settings, extent)},
                                               {"bent", rgb10_a2, frame, extent}});
    if (settings.history) {
        plan.images.push_back({"levels_before", depths, history, extent, depth_levels});
        plan.images.push_back({"history_before", rgb10_a2, history, extent});
        plan.images.push_back({"history", rgb10_a2, frame, extent});
        plan.exchanged = {{"levels_before", "levels"}, {"history_before", "history"}};
        if (settings.bent_normals) {
            plan.images.push_back({"bent_before", rgb10_a2, history, extent});
            plan.exchanged.push_back({"bent_before", "bent"});
        }
    }
    plan.passes = passes_of(settings, taken, numbers);
    plan.result = "shown";
    return plan;
}

Taken taken_of(const scene::GBuffer& view, const Settings& settings) {
    return {.view = {view.camera, view.extent, view.border},
            .radius = settings.radius,
            .encoding = view.stored ? view.stored->encoding : scene::Encoding{},
            .normals = !view.normal.empty(),
            .deep = starts_deep(settings, view.camera)};
}

// texels: the bits of rgb10_a2.
std::vector<glm::vec3> bends_of(const std::vector<float>& texels) {
    std::vector<glm::vec3> bends;
    for (const float texel : texels)
        bends.emplace_back(2.0F * glm::unpackUnorm3x10_1x2(std::bit_cast<std::uint32_t>(texel)) - 1.0F);
    return bends;
}

scene::GBuffer shape_of(const View& view) {
    return {.extent = view.extent, .camera = view.camera, .border = view.border};
}

class ThreePasses : public FramePasses {
  public:
    ThreePasses(const gpu::Device& device, const scene::PassLibrary& passes)
        : device_(&device), executor_(device, passes), resources_(device) {}

    void take(const scene::GBuffer& view, const Settings& settings, bool follows) override {
        if (!follows) gloam_cut(&frame_);
        settings_ = settings;
        const bool deep = taken_.deep;
        taken_ = taken_of(view, settings);
        if (follows && !view.camera.orthographic())
            taken_.deep = deep;  // a camera that zooms keeps its images
        const Plan plan = plan_for(settings, taken_, frame_);
        resources_.provide(plan);
        provide_tiles();
        upload(view, true, resources_);
        if (!follows) resources_.restart(plan);  // what is read without weight still tells in the last bit
    }

    [[nodiscard]] Frame next(int repeat, const PassWatcher& watcher) override {
        advance();
        const Plan plan = plan_for(settings_, taken_, frame_);
        const std::vector<Step> steps = executor_.steps(plan.passes, resources_);
        Frame frame;
        frame.times = run(*device_, steps, repeat, watcher);
        frame.filtered = frame.occlusion = resources_.image("shown").download();
        if (settings_.bent_normals) frame.bent = bends_of(resources_.image("bent").download());
        crop(shape_of(taken_.view), frame);
        frame.memory_bytes = memory_of(steps);
        resources_.exchange(plan.exchanged);
        last_ = taken_.view;
        return frame;
    }

  private:
    // The list of tiles, where branches are no skips and a dispatch can be as long as the list. With other
    // texels it begins with zeros: none is known to be blank.
    void provide_tiles() {
        const gpu::DeviceInfo& info = device_->info();
        const gpu::Extent view = taken_.view.extent;
        const gpu::Extent count = tiles_of(settings_, view);
        taken_.tiles = info.type == "cpu" && count.width * count.height <= info.max_group_count[0];
        if (!taken_.tiles) return;
        gpu::Buffer& list = resources_.buffer(tile_list, 8 * (2 + count.width * count.height));
        const gpu::Extent texels = swept_of(settings_, view);
        if (texels != listed_) std::ranges::fill(list.bytes(), std::byte{0});
        listed_ = texels;
    }

    // To the numbers of the next frame.
    void advance() {
        const std::optional<glm::mat4>& moved = taken_.view.camera.previous_from_current;
        const bool follows = moved && cut_between(shape_of(last_), shape_of(taken_.view)).empty();
        if (!settings_.history) gloam_cut(&frame_);
        gloam_next(&frame_, settings_of(settings_, taken_), camera_of(taken_.view),
                   follows ? &(*moved)[0][0] : nullptr);
    }

    const gpu::Device* device_;
    Executor executor_;
    Resources resources_;
    Settings settings_;
    Taken taken_;
    gpu::Extent listed_;   // texels of which the list of tiles knows
    View last_;            // of the frame before
    gloam_frame frame_{};  // of the last frame, until advance()
};

}  // namespace

Plan frame_plan(const Settings& settings, const PlanOptions& options) {
    const View shown = view_of(options);
    const Taken taken{.view = shown,
                      .encoding = options.encoding,
                      .normals = options.normals,
                      .deep = starts_deep(settings, shown.camera)};
    Plan plan = plan_for(settings, taken, first_of(settings, taken));
    for (PlannedImage& image : plan.images)
        if (image.name == "normal" && options.encoding.unorm) image.format = rgba8;
    return plan;
}

Plan frame_plan(const Settings& settings, const scene::GBuffer& view) {
    const Taken taken = taken_of(view, settings);
    return plan_for(settings, taken, first_of(settings, taken));
}

std::unique_ptr<FramePasses> frame_passes(const gpu::Device& device, const scene::PassLibrary& passes) {
    return std::make_unique<ThreePasses>(device, passes);
}

}  // namespace gloam::effect
