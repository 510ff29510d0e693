// SPDX-License-Identifier: MIT
#include "effect/ambient_occlusion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "effect/internal/ambient_occlusion_impl.hpp"
#include "effect/internal/require_view.hpp"
#include "effect/internal/work.hpp"
#include "effect/methods.hpp"
#include "scene/guard_band.hpp"

namespace gloam::effect {
namespace {

std::array<std::int32_t, 2> words_of_size(gpu::Extent extent) {
    return {static_cast<std::int32_t>(extent.width), static_cast<std::int32_t>(extent.height)};
}

}  // namespace

void AmbientOcclusion::Impl::allocate(gpu::Extent size) {
    given.extent = size;
    half.reset();
    if (settings.resolution == Resolution::half)
        half = std::make_unique<HalfResolution>(*device, library, size);
    images.emplace(*device, half ? half_of(size) : size, settings.precision);
}

// Uploads the images of a view and sets its constants. Positions in the previous frame matter only if the
// history follows them.
void AmbientOcclusion::Impl::take(const scene::GBuffer& new_view) {
    require_guard(new_view, settings);
    require_layers(new_view, settings);
    (void)scene::frame_of(new_view);
    (half ? half->inputs : images->inputs).take(*device, new_view);
    given.camera = new_view.camera;
    given.border = new_view.border;
    view = working_view(given, settings.resolution);
    surfaces.take(new_view, given);
    if (half) half->take(given, previous_given, settings, images->inputs);
    images->watch_objects(*device);
    if (remaps(settings) && (!half || filters(settings))) images->map(*device, settings.output);
    occlusion_constants = occlusion_parameters(view, settings);
    method.as<MethodValues>()[0] = settings.own;
    prepared.take(view, settings);
    samples.take(settings);
    filter_constants = filter_parameters(view, settings);
    remap_constants = remap_parameters(view, settings);
    const std::int32_t reach = filter_reach(settings);
    select_filtered_constants = {.size = words_of_size(view.extent), .reach = {reach, reach}};
    open_search.take(view, settings);
}

// Whether the view holds the positions of its points in the previous view, and a history depends on them.
bool AmbientOcclusion::Impl::knows_motion() const {
    return moves_history() && images->inputs.previous_position.has_value();
}

// The history into which the samples are blended, and the one that this makes.
const gpu::Image& AmbientOcclusion::Impl::history() const {
    if (shows_alone(settings)) return nothing;
    return moves_history() ? images->reprojected : images->before;
}

const gpu::Image& AmbientOcclusion::Impl::history_after() const {
    return shows_alone(settings) ? nothing : images->after;
}

Program AmbientOcclusion::Impl::program() const {
    Program program = program_for(settings);
    program.moving_objects = watches_objects();
    program.listed = lists_tiles();
    program.shows = lists_tiles() && filters_frame();
    program.orthographic = view.camera.orthographic();
    return program;
}

ReprojectionProgram AmbientOcclusion::Impl::reprojection_program() const {
    return {.precision = settings.precision,
            .moving_objects = knows_motion(),
            .listed = lists_tiles(),
            .taps = settings.taps,
            .nearest_index = settings.nearest_index,
            .orthographic = view.camera.orthographic(),
            .previous_orthographic = previous_view.camera.orthographic(),
            .keeps_displacement = watches_objects()};
}

// The list of tiles on which a pass runs; none: all tiles.
std::optional<TileLists> AmbientOcclusion::Impl::listed(TileLists list) const {
    return lists_tiles() ? std::optional(list) : std::nullopt;
}

// The pass, changed to run over the list if the frame uses lists.
Step AmbientOcclusion::Impl::over(TileLists list, Step pass) const {
    if (!listed(list)) return pass;
    pass.indirect = &images->tiles.lists();
    pass.offset = offset_of(list);
    return pass;
}

void AmbientOcclusion::Impl::append_selection(std::vector<Step>& passes) {
    if (!lists_tiles()) return;
    const Tiles& tiles = images->tiles;
    if (finds_open_tiles())
        open_search.append_steps(pipelines, tiles, images->inputs.depth, images->inputs.normal, passes);
    select_constants = select_parameters();
    passes.push_back({"select_tiles",
                      &pipelines.selection(),
                      {images->inputs.depth, tiles.before(), tiles.after(), tiles.lists(), tiles.open()},
                      bytes_of(select_constants),
                      tile_groups()});
}

// Groups of a pass with one invocation a tile.
std::array<std::uint32_t, 3> AmbientOcclusion::Impl::tile_groups() const {
    const auto tiles = groups_for(view.extent);
    return groups_for({tiles[0], tiles[1]});
}

// Guard band on each side of the view that is not shaded.
gpu::Extent AmbientOcclusion::Impl::unshaded_band() const {
    return settings.guard_history ? gpu::Extent{} : view.border;
}

SelectParameters AmbientOcclusion::Impl::select_parameters() const {
    std::uint32_t written = second_is_after ? image_second_history : image_first_history;
    if (moves_history()) written |= image_reprojected;
    if (filters_frame()) written |= image_filtered;
    if (shows_alone(settings)) written = image_filtered;
    if (remaps_images()) written |= image_mapped;
    if (remaps_images() && filters_frame() && !half) written |= image_filtered_mapped;
    return {.size = words_of_size(view.extent),
            .band = words_of_size(unshaded_band()),
            .written = written,
            .background = settings.skip_background ? 1U : 0U,
            .settled = settings.skip_settled && progress.settled() ? 1U : 0U,
            .open_tiles = finds_open_tiles() ? 1U : 0U};
}

std::vector<Step> AmbientOcclusion::Impl::steps() {
    const gpu::Image& positions =
        images->inputs.previous_position ? *images->inputs.previous_position : nothing;
    const gpu::Image& displacement = images->displacement ? *images->displacement : no_displacement;
    const Tiles& tiles = images->tiles;
    std::vector<Step> passes;
    if (progress.first_of_view()) append_inputs(passes);
    append_selection(passes);
    if (moves_history()) {
        passes.push_back(over(TileLists::shaded, {"reproject",
                                                  &pipelines.reprojection(reprojection_program()),
                                                  {images->inputs.depth, positions, images->before,
                                                   images->reprojected, tiles.lists(), displacement},
                                                  bytes_of(reprojection_constants)}));
    }
    const gpu::Image& layers = images->inputs.layers ? *images->inputs.layers : nothing;
    prepared.append_steps({images->inputs.depth, images->inputs.normal, history(), method, layers}, passes);
    samples.append_step(passes);
    occlusion_constants.still = progress.first_of_view() ? 0 : 1;
    const auto occlusion = [&](const char* name, TileLists list) {
        Program of_list = program();
        of_list.list = list;
        passes.push_back(over(list, {name,
                                     &pipelines.occlusion(of_list),
                                     {images->inputs.depth, images->inputs.normal, history(), history_after(),
                                      tiles.after(), displacement, method, prepared.image_or(nothing), layers,
                                      tiles.lists(), images->filtered, samples.image_or(nothing)},
                                     bytes_of(occlusion_constants)}));
    };
    occlusion("ambient_occlusion", finds_open_tiles() ? TileLists::sampled : TileLists::shaded);
    if (finds_open_tiles()) occlusion("ambient_occlusion_open", TileLists::open);
    append_filter(passes);
    append_remap(passes);
    append_result(passes);
    return passes;
}

void AmbientOcclusion::Impl::append_inputs(std::vector<Step>& passes) {
    surfaces.append_steps(pipelines, half ? half->inputs : images->inputs, nothing, passes);
    if (half) half->append_inputs(images->inputs, nothing, passes);
}

// At half the resolution the result comes back to the view's size.
void AmbientOcclusion::Impl::append_result(std::vector<Step>& passes) {
    if (!half) return;
    const UpsampleProgram program =
        upsample_program_for(settings, filters_frame(), view.camera.orthographic());
    half->append_result(images->inputs, program.history ? images->after : images->filtered, program, passes);
}

bool AmbientOcclusion::Impl::finds_open_tiles() const {
    return lists_tiles() && open_search.searches(watches_objects());
}

void AmbientOcclusion::Impl::append_filter(std::vector<Step>& passes) {
    if (!filters_frame()) return;
    const gpu::Buffer& lists = images->tiles.lists();
    if (lists_tiles()) {
        passes.push_back({"select_filtered_tiles",
                          &pipelines.filtered_selection(),
                          {images->tiles.after(), lists},
                          bytes_of(select_filtered_constants),
                          tile_groups()});
    }
    const auto along = [&](const char* name, TileLists list, const gpu::Image& from, const gpu::Image& to) {
        FilterProgram compiled = filter_program_for(settings, listed(list));
        compiled.along_y = list == TileLists::filtered_y;
        compiled.orthographic = view.camera.orthographic();
        passes.push_back(
            over(list, {name,
                        &pipelines.filter(compiled),
                        {images->inputs.depth, images->after, to, images->inputs.normal, lists, from},
                        bytes_of(filter_constants),
                        filter_groups_for(view.extent)}));
    };
    along("filter_x", TileLists::filtered_x, images->filtered, images->half_filtered);
    along("filter_y", TileLists::filtered_y, images->half_filtered, images->filtered);
}

// Remaps the history and the filter's result for display.
void AmbientOcclusion::Impl::append_remap(std::vector<Step>& passes) {
    if (!remaps_images()) return;
    const gpu::Buffer& lists = images->tiles.lists();
    using Held = std::optional<HistoryPrecision>;
    const auto map = [&](const char* name, TileLists list, Held held, const gpu::Image& from,
                         const gpu::Image& to) {
        passes.push_back(over(list, {name,
                                     &pipelines.remapping(held, listed(list), settings.output),
                                     {images->inputs.depth, from, to, lists},
                                     bytes_of(remap_constants)}));
    };
    if (shows_alone(settings)) return map("remap", TileLists::shaded, {}, images->filtered, *images->mapped);
    map("remap", TileLists::shaded, settings.precision, images->after, *images->mapped);
    if (!filters_frame() || half) return;
    const gpu::Image& to = *images->filtered_mapped;
    map("remap_filtered", TileLists::shaded, {}, images->filtered, to);
    // The tiles that only the filter changes.
    if (lists_tiles()) map("remap_filtered_tiles", TileLists::filtered_y, {}, images->filtered, to);
}

Frame AmbientOcclusion::Impl::collect() const {
    const bool mapped = remaps_images();
    const gpu::Image& filtered = half ? half->result() : mapped ? *images->filtered_mapped : images->filtered;
    Frame frame;
    if (shows_alone(settings)) {
        frame.occlusion = (mapped ? *images->mapped : images->filtered).download();
        frame.convergence = frame.kept = std::vector<float>(frame.occlusion.size(), 0.0F);
    } else {
        HistoryTexels result = history_in(images->after);
        frame.occlusion = mapped ? images->mapped->download() : std::move(result.occlusion);
        frame.convergence = std::move(result.samples);
        frame.kept = history_in(history()).samples;
    }
    frame.filtered = filters_frame() || half ? filtered.download() : frame.occlusion;
    for (float& value : frame.convergence) value = std::min(value / settings.weight_max, 1.0F);
    frame.work = work(frame.convergence);
    if (half) {
        frame.occlusion = filters_frame() ? expanded(frame.occlusion, given.extent) : frame.filtered;
        frame.convergence = expanded(frame.convergence, given.extent);
        frame.kept = expanded(frame.kept, given.extent);
    }

    const scene::GBuffer shape{.extent = given.extent, .border = given.border};
    frame.extent = scene::frame_of(shape);
    for (std::vector<float>* image : {&frame.occlusion, &frame.filtered, &frame.convergence, &frame.kept})
        *image = scene::cropped(shape, *image);
    return frame;
}

Work AmbientOcclusion::Impl::work(std::span<const float> convergence) const {
    const bool selected = lists_tiles();
    const std::uint32_t samples =
        samples_taken(method_named(settings.method), std::max(settings.samples, settings.samples_converged),
                      settings.own.steps);
    Work total =
        summed(images->tiles.after().as<const TileState>(), view.extent, unshaded_band(), samples, selected);
    const SelectedTiles tiles = images->tiles.counts();
    total.tiles_shaded = selected ? tiles.shaded : total.tiles;
    if (filters_frame()) total.tiles_filtered = selected ? tiles.filtered : total.tiles;
    total.tiles_blank = tiles.background;
    total.tiles_open = tiles.open;
    total.tiles_settled = tiles.settled;
    total.tiles_unfiltered = tiles.filtered_enough;
    if (settings.filter == Filter::convergence) {
        for (const float value : convergence) total.converged += value >= settings.c_adaptive ? 1 : 0;
    }
    return total;
}

AmbientOcclusion::AmbientOcclusion(const gpu::Device& device, const scene::PassLibrary& passes,
                                   gpu::Extent extent)
    : impl_(std::make_unique<Impl>(device, passes, extent)) {}
AmbientOcclusion::~AmbientOcclusion() = default;
AmbientOcclusion::AmbientOcclusion(AmbientOcclusion&&) noexcept = default;
AmbientOcclusion& AmbientOcclusion::operator=(AmbientOcclusion&&) noexcept = default;

void AmbientOcclusion::begin(const scene::GBuffer& view, const Settings& settings) {
    Impl& impl = *impl_;
    validate(settings);
    const bool other_images =
        settings.precision != impl.settings.precision || settings.resolution != impl.settings.resolution;
    impl.settings = settings;
    if (other_images) impl.allocate(impl.given.extent);
    impl.take(view);
    impl.samples.restart();
    impl.listing.restart();
    impl.open_search.restart();
    impl.images->tiles.forget();
    impl.images->before.upload(std::vector<float>(4 * pixels_of(impl.view.extent), 0.0F));
    impl.progress.begin();
}

void AmbientOcclusion::advance(const scene::GBuffer& view) {
    Impl& impl = *impl_;
    if (!impl.progress.has_view()) throw std::logic_error("no view: begin() must come before advance()");
    const bool resized = view.extent != impl.given.extent;
    if (resized) impl.allocate(view.extent);
    if (resized || !view.camera.previous_from_current) return begin(view, impl.settings);
    impl.previous_given = impl.given;
    impl.previous_view = impl.view;
    impl.take(view);
    impl.reprojection_constants = reprojection_parameters(impl.view, impl.previous_view, impl.settings);
    if (impl.half)
        impl.reprojection_constants.previous_from_current =
            half_previous_from_current(impl.given, impl.previous_given);
    impl.progress.advance();
}

void AmbientOcclusion::watch(PassWatcher watcher) {
    impl_->watcher = std::move(watcher);
}

Frame AmbientOcclusion::next(int repeat) {
    Impl& impl = *impl_;
    if (!impl.progress.has_view()) throw std::logic_error("no view: begin() must come before next()");
    if (repeat < 1) throw std::invalid_argument(fmt::format("repeat {}: expected 1 or more", repeat));
    // Each run reads the same history and writes the same images, so a repeated run changes nothing.
    const std::vector<Step> steps = impl.steps();
    std::vector<PassTime> times = run(
        *impl.device, steps, groups_for(impl.view.extent), repeat, [&] { impl.images->tiles.clear(); },
        impl.watcher);
    Frame frame = impl.collect();
    frame.memory_bytes = memory_of(steps);
    frame.times = std::move(times);
    const SelectedTiles found = impl.images->tiles.counts();
    impl.open_search.advance(impl.finds_open_tiles(), found);
    impl.listing.advance(impl.lists_tiles(), found, frame.work.tiles);
    impl.progress.count_frame();
    impl.samples.advance();
    std::swap(impl.images->before, impl.images->after);
    impl.second_is_after = !impl.second_is_after;
    impl.images->tiles.advance();
    return frame;
}

}  // namespace gloam::effect
