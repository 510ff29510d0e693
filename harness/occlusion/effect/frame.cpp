// SPDX-License-Identifier: MIT
#include "effect/internal/frame.hpp"

#include <fmt/format.h>
#include <passes/frame/gloam_frame.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "effect/internal/executor.hpp"
#include "effect/internal/passes.hpp"
#include "effect/internal/study_frame.hpp"

namespace gloam::effect {
namespace {

using enum backend::vulkan::Format;

constexpr std::uint32_t depth_levels = 5;
constexpr const char* tile_list = "tiles";  // glsl/passes/frame/tile_list.glsl

// The lists in that buffer, by their numbers.
enum List : std::uint32_t { sweeping, refining, filtering, joining };
constexpr std::uint32_t bytes_of_work = 16;

// What a frame takes of the engine.
struct EngineInputs {
    View view;
    float radius = 1.0F;
    scene::Encoding encoding{};
    bool normals = true;  // there are some
    bool skips = false;   // the sweep has a list of tiles
    bool deep = false;    // depth has 32 bits: frame/parameters.glsl
};

// What tiles.comp is given.
struct TileParameters {
    std::array<float, 2> inverse_size;
    backend::Extent count;
    std::uint32_t frame;
    std::uint32_t stands;
};

bool has_tiles(const Settings& settings) {
    return settings.resolution == Resolution::tiles;
}

// Of the first sweep: pixels of the view from one texel to the next.
std::uint32_t stride_of(const Settings& settings) {
    return settings.resolution == Resolution::full ? 1 : 2;
}

// Its texels.
backend::Extent swept_of(const Settings& settings, backend::Extent view) {
    const std::uint32_t stride = stride_of(settings);
    return {(view.width + stride - 1) / stride, (view.height + stride - 1) / stride};
}

// Of the lists, as their passes declare them.
std::size_t list_bytes(const Settings& settings, backend::Extent view, bool skips) {
    const backend::Extent count = tiles_of(view);
    const std::size_t words = skips ? 4 : 2;
    return has_tiles(settings) || skips ? 4 * (4 * 4 + 1 + words * count.width * count.height) : 0;
}

gloam_camera camera_of(const View& view) {
    gloam_camera camera{};
    std::copy_n(&view.camera.proj_vk[0][0], 16, camera.projection);
    std::copy_n(&view.camera.view[0][0], 16, camera.view);
    return camera;
}

gloam_settings settings_of(const Settings& settings, const EngineInputs& inputs) {
    const backend::Extent extent = inputs.view.extent;
    return {
        .preset = {static_cast<gloam_resolution>(settings.resolution), settings.mark, settings.history_range,
                   settings.history_sharpness, inputs.view.camera.orthographic(), inputs.deep},
        .size = {static_cast<int>(extent.width), static_cast<int>(extent.height)},
        .radius = inputs.radius,
        .depth_buffer = inputs.encoding.depth_buffer};
}

// Whether depth of 16 bits is too coarse from the beginning.
bool starts_deep(const Settings& settings, const scene::CameraFrame& camera) {
    constexpr float narrow = 0.268F;  // tangent of half of 30 degrees, across the longer side of the image
    const float across = 1.0F / std::min(std::abs(camera.proj_vk[0][0]), std::abs(camera.proj_vk[1][1]));
    return settings.deep || camera.orthographic() || across < narrow;
}

// The first frame of a sequence.
gloam_frame first_of(const Settings& settings, const EngineInputs& inputs) {
    gloam_frame frame{};
    gloam_next(&frame, settings_of(settings, inputs), camera_of(inputs.view), nullptr);
    return frame;
}

// Groups of 16 x 8 invocations, which make `x` x `y` pixels each.
std::array<std::uint32_t, 3> groups_of(backend::Extent extent, std::uint32_t x, std::uint32_t y) {
    return {(extent.width + 16 * x - 1) / (16 * x), (extent.height + 8 * y - 1) / (8 * y), 1};
}

using Constants = std::vector<backend::vulkan::SpecializationConstant>;

// Those that all passes have, behind a pass' own.
Constants constants_of(const Settings& settings, const EngineInputs& inputs, Constants own) {
    own.insert(own.end(), {{.id = 1, .bits = flag(inputs.view.camera.orthographic())},
                           {.id = 8, .bits = flag(settings.history)},
                           {.id = 9, .bits = flag(inputs.deep)}});
    return own;
}

PlannedPass first_pass(const Settings& settings, const EngineInputs& inputs, const gloam_frame& frame) {
    PassSource source{.file = "frame/prepare.comp", .constants = constants_of(settings, inputs, {})};
    if (inputs.deep) source.defines.emplace_back("GLOAM_LEVELS r32f");
    return single_pass("prepare", source,
                       {"depth", "levels/0", "levels/1", "levels/2", "levels/3", "levels/4",
                        settings.history ? "levels_before" : nothing_image},
                       frame.prepare, groups_of(inputs.view.extent, 2, 2));
}

// The pass makes the tiles of a list, so many a group: at most all of the view.
void dispatch_by(List list, std::uint32_t tiles_of_group, backend::Extent view, PlannedPass& pass) {
    const backend::Extent count = tiles_of(view);
    const std::uint32_t most = (count.width * count.height + tiles_of_group - 1) / tiles_of_group;
    pass.groups = {most, 1, 1};
    pass.groups_from = tile_list;
    pass.groups_at = list * bytes_of_work;
}

// Binds the lists behind the other resources of the pass.
void bind_lists(const EngineInputs& inputs, PlannedPass& pass) {
    pass.source.defines.push_back(fmt::format("GLOAM_TILES {}", pass.resources.size()));
    if (inputs.skips) pass.source.defines.emplace_back("GLOAM_SKIPS");
    pass.resources.emplace_back(tile_list);
}

// Join, or filter.
PlannedPass last_pass(const Settings& settings, const EngineInputs& inputs, const gloam_frame& frame,
                      bool joins) {
    gloam_last parameters = joins ? frame.join : frame.filter;
    parameters.albedo = settings.bounce_albedo;
    PassSource source{.file = joins ? "frame/join.comp" : "frame/filter.comp",
                      .constants = constants_of(settings, inputs, {}),
                      .unrolls = true};
    define_output(settings.output, source.defines);
    if (settings.bounce_albedo > 0.0F) source.defines.emplace_back("GLOAM_MULTI_BOUNCE");
    if (has_tiles(settings)) source.defines.emplace_back("GLOAM_MARKS");
    if (joins && inputs.deep) source.defines.emplace_back("GLOAM_TEXELS rg32ui");
    std::vector<std::string> resources{has_tiles(settings) && !joins ? "full_texels" : "texels"};
    if (joins) resources.emplace_back("levels");
    resources.emplace_back("shown");
    for (const char* image : {"history_before/linear", "levels_before", "history"})
        resources.emplace_back(settings.history ? image : nothing_image);
    PlannedPass pass = single_pass(joins ? "join" : "filter", source, std::move(resources), parameters,
                                   groups_of(inputs.view.extent, 2, joins ? 2 : 1));
    if (has_tiles(settings))
        dispatch_by(joins ? joining : filtering, joins ? 8 : 4, inputs.view.extent, pass);
    return pass;
}

// A sweep with so many slices and steps. refines: that of the marked tiles.
PlannedPass sweep_pass(const Settings& settings, const EngineInputs& inputs, const gloam_sweep& parameters,
                       bool refines) {
    const bool before = has_tiles(settings) && !refines;
    const std::uint32_t slices = before ? 1 : slices_of(settings);
    const std::uint32_t stride = refines ? 1 : stride_of(settings);
    PassSource source{
        .file = "frame/sweep.comp",
        .constants = constants_of(settings, inputs,
                                  {{.id = 2, .bits = flag(inputs.encoding.world)},
                                   {.id = 3, .bits = flag(inputs.encoding.octahedral)},
                                   {.id = 4, .bits = flag(inputs.encoding.unorm)},
                                   {.id = 5, .bits = slices},
                                   {.id = 6, .bits = before ? steps_before_tiles : settings.own.steps},
                                   {.id = 7, .bits = stride}}),
        .unrolls = slices < 4};
    if (inputs.deep) source.defines.emplace_back("GLOAM_TEXELS rg32ui");
    if (!inputs.normals) source.defines.emplace_back("GLOAM_NORMALS_FROM_DEPTH");
    if (refines) source.defines.emplace_back("GLOAM_MARKS");
    std::vector<std::string> resources{"levels", inputs.normals ? "normal" : "depth",
                                       refines ? "full_texels" : "texels"};
    PlannedPass pass = single_pass(refines ? "refine" : "sweep", source, std::move(resources), parameters,
                                   groups_of(swept_of(settings, inputs.view.extent), 1, 1));
    if (inputs.normals) pass.parameters.resize(offsetof(gloam_sweep, depth));
    if (refines || inputs.skips)
        dispatch_by(refines ? refining : sweeping, 2 * stride * stride, inputs.view.extent, pass);
    return pass;
}

// Lists the tiles of the sweep on CPUs' drivers.
PlannedPass tile_pass(const Settings& settings, const EngineInputs& inputs, const gloam_frame& frame) {
    const backend::Extent count = tiles_of(inputs.view.extent);
    const TileParameters parameters{
        .inverse_size = {frame.prepare.inverse_size[0], frame.prepare.inverse_size[1]},
        .count = count,
        .frame = static_cast<std::uint32_t>(frame.frames),
        .stands = flag(frame.still != 0)};
    const PassSource source{
        .file = "frame/tiles.comp",
        .constants = constants_of(settings, inputs, {{.id = 7, .bits = stride_of(settings)}})};
    return single_pass("tiles", source, {"levels", settings.history ? "levels_before" : nothing_image},
                       parameters, {(count.width + 7) / 8, count.height, 1});
}

PlannedPass mark_pass(const EngineInputs& inputs, const gloam_frame& frame) {
    const backend::Extent count = tiles_of(inputs.view.extent);
    return single_pass("mark", {.file = "frame/mark.comp"}, {"texels", "marks"}, frame.mark,
                       {(count.width + 7) / 8, (count.height + 7) / 8, 1});
}

// Binds the images of bent normals behind the other resources.
void bind_bends(const Settings& settings, PlannedPass& pass) {
    const bool full = pass.name == "refine" || (pass.name == "filter" && has_tiles(settings));
    pass.source.defines.emplace_back("GLOAM_BENT_NORMALS");
    pass.resources.emplace_back(full ? "full_bends" : "bends");
    if (pass.name == "sweep" || pass.name == "refine") return;
    pass.resources.emplace_back("bent");
    pass.resources.emplace_back(settings.history ? "bent_before/linear" : nothing_image);
}

// Binds the texels, and their bends, that refine and join write for one another behind these.
void bind_others(const Settings& settings, const std::string& texels, const std::string& bends,
                 PlannedPass& pass) {
    pass.source.defines.push_back(fmt::format("GLOAM_OTHER_TEXELS {}", pass.resources.size()));
    pass.resources.push_back(texels);
    if (settings.bent_normals) pass.resources.push_back(bends);
}

std::vector<PlannedPass> passes_of(const Settings& settings, const EngineInputs& inputs,
                                   const gloam_frame& frame) {
    std::vector<PlannedPass> passes{first_pass(settings, inputs, frame)};
    if (inputs.skips) passes.push_back(tile_pass(settings, inputs, frame));
    passes.push_back(sweep_pass(settings, inputs, frame.sweep, false));
    if (has_tiles(settings)) {
        passes.push_back(mark_pass(inputs, frame));
        passes.push_back(sweep_pass(settings, inputs, frame.sweep, true));
    }
    if (settings.resolution != Resolution::full) passes.push_back(last_pass(settings, inputs, frame, true));
    if (settings.resolution != Resolution::half) passes.push_back(last_pass(settings, inputs, frame, false));
    for (PlannedPass& pass : passes) {
        const bool bends = pass.name != "prepare" && pass.name != "tiles" && pass.name != "mark";
        if (settings.bent_normals && bends) bind_bends(settings, pass);
        if (pass.name == "refine") bind_others(settings, "texels", "bends", pass);
        if (has_tiles(settings) && pass.name == "join")
            bind_others(settings, "full_texels", "full_bends", pass);
        if (inputs.skips || (has_tiles(settings) && pass.name != "sweep")) bind_lists(inputs, pass);
    }
    return passes;
}

// The images that the passes write, but for those that the next frame reads.
std::vector<PlannedImage> written_of(const Settings& settings, const EngineInputs& inputs) {
    const backend::Extent view = inputs.view.extent;
    const backend::vulkan::Format texels = inputs.deep ? rg32ui : r32ui;  // gloam/filter/frame_texel.glsl
    const auto written = [](const char* name, backend::vulkan::Format format, backend::Extent extent) {
        return PlannedImage{name, format, PlannedImage::Origin::frame, extent};
    };
    std::vector<PlannedImage> images{written("texels", texels, swept_of(settings, view)),
                                     written("shown", format_of(settings.output), view)};
    if (has_tiles(settings)) {
        images.push_back(written("full_texels", texels, view));
        images.push_back(written("marks", r8, tiles_of(view)));
    }
    if (!settings.bent_normals) return images;
    images.push_back(written("bends", rgba8, swept_of(settings, view)));
    if (has_tiles(settings)) images.push_back(written("full_bends", rgba8, view));
    images.push_back(written("bent", rgb10_a2, view));
    return images;
}

Plan plan_for(const Settings& settings, const EngineInputs& inputs, const gloam_frame& numbers) {
    using enum PlannedImage::Origin;
    const backend::Extent extent = inputs.view.extent;
    const backend::vulkan::Format depths = inputs.deep ? r32f : r16f;
    Plan plan;
    plan.images = {{"depth", r32f, engine, extent},                   // as it is stored
                   {"levels", depths, frame, extent, depth_levels}};  // eye-linear depth in radii
    if (inputs.normals) plan.images.push_back({"normal", rgba32f, engine, extent});
    std::ranges::move(written_of(settings, inputs), std::back_inserter(plan.images));
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
    if (const std::size_t bytes = list_bytes(settings, extent, inputs.skips))
        plan.buffers.push_back({tile_list, std::vector<std::byte>(bytes)});
    plan.passes = passes_of(settings, inputs, numbers);
    plan.result = "shown";
    return plan;
}

EngineInputs inputs_of(const scene::GBuffer& view, const Settings& settings) {
    return {.view = {view.camera, view.extent, view.border},
            .radius = settings.radius,
            .encoding = view.stored ? view.stored->encoding : scene::Encoding{},
            .normals = !view.normal.empty(),
            .deep = starts_deep(settings, view.camera)};
}

scene::GBuffer shape_of(const View& view) {
    return {.extent = view.extent, .camera = view.camera, .border = view.border};
}

class ThreePasses : public FramePasses {
  public:
    ThreePasses(const backend::vulkan::Device& device, const scene::PassLibrary& passes)
        : device_(&device), executor_(device, passes), resources_(device) {}

    void take(const scene::GBuffer& view, const Settings& settings, bool follows) override {
        if (!follows) gloam_cut(&frame_);
        const EngineInputs before = std::exchange(inputs_, inputs_of(view, settings));
        if (follows && !view.camera.orthographic())
            inputs_.deep = before.deep;  // a camera that zooms keeps its images
        inputs_.skips = settings.skips && device_->info().type == "cpu";
        Plan plan = plan_for(settings, inputs_, frame_);
        const bool same_texels = before.view.extent == view.extent && before.deep == inputs_.deep &&
                                 stride_of(settings_) == stride_of(settings);
        if (before.skips && inputs_.skips && same_texels) plan.buffers.clear();  // they know what is blank
        settings_ = settings;
        resources_.provide(plan);
        upload(view, true, resources_);
        if (!follows) resources_.restart(plan);  // what is read without weight still tells in the last bit
    }

    [[nodiscard]] Frame next(int repeat, const PassWatcher& watcher) override {
        advance();
        const Plan plan = plan_for(settings_, inputs_, frame_);
        const std::vector<Step> steps = executor_.steps(plan.passes, resources_);
        Frame frame;
        frame.times = run(*device_, steps, repeat, watcher);
        frame.filtered = frame.occlusion = resources_.image("shown").download();
        if (has_tiles(settings_))
            for (const float mark : resources_.image("marks").download())
                frame.tiles.push_back(mark > 0.5F ? TileWork::full : TileWork::half);
        if (settings_.bent_normals) frame.bent = vectors_of(resources_.image("bent").download());
        for (glm::vec3& bend : frame.bent) bend = 2.0F * bend - 1.0F;
        crop(shape_of(inputs_.view), frame);
        frame.memory_bytes = memory_of(steps);
        resources_.exchange(plan.exchanged);
        last_ = inputs_.view;
        return frame;
    }

  private:
    // To the numbers of the next frame.
    void advance() {
        const std::optional<glm::mat4>& moved = inputs_.view.camera.previous_from_current;
        const bool follows = moved && cut_between(shape_of(last_), shape_of(inputs_.view)).empty();
        if (!settings_.history) gloam_cut(&frame_);
        gloam_next(&frame_, settings_of(settings_, inputs_), camera_of(inputs_.view),
                   follows ? &(*moved)[0][0] : nullptr);
    }

    const backend::vulkan::Device* device_;
    Executor executor_;
    Resources resources_;
    Settings settings_;
    EngineInputs inputs_;
    View last_;            // of the frame before
    gloam_frame frame_{};  // of the last frame, until advance()
};

}  // namespace

Plan frame_plan(const Settings& settings, const PlanOptions& options) {
    EngineInputs inputs{.view = view_of(options), .encoding = options.encoding, .normals = options.normals};
    inputs.deep = starts_deep(settings, inputs.view.camera);
    Plan plan = plan_for(settings, inputs, first_of(settings, inputs));
    for (PlannedImage& image : plan.images)
        if (image.name == "normal" && options.encoding.unorm) image.format = rgba8;
    return plan;
}

Plan frame_plan(const Settings& settings, const scene::GBuffer& view) {
    const EngineInputs inputs = inputs_of(view, settings);
    return plan_for(settings, inputs, first_of(settings, inputs));
}

std::unique_ptr<FramePasses> frame_passes(const backend::vulkan::Device& device,
                                          const scene::PassLibrary& passes) {
    return std::make_unique<ThreePasses>(device, passes);
}

}  // namespace gloam::effect
