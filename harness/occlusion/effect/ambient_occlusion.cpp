// SPDX-License-Identifier: MIT
#include "effect/ambient_occlusion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "effect/internal/executor.hpp"
#include "effect/internal/frame.hpp"
#include "effect/internal/frame_images.hpp"
#include "effect/internal/progress.hpp"
#include "effect/internal/short_frame.hpp"
#include "effect/internal/work.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

// The state of the effect: the last view, images and histories, and what the next frame runs.
struct AmbientOcclusion::Impl {
    Impl(const gpu::Device& the_device, const scene::PassLibrary& passes, gpu::Extent size)
        : device(&the_device),
          executor(the_device, passes),
          resources(the_device),
          short_frame(the_device, passes) {
        moment.has_tiles = moment.shows_unfiltered = true;
        moment.counting = runs_on_cpu(the_device) ? Counting::each_invocation : Counting::each_group;
        look({.camera = {}, .extent = size, .border = {}}, {});
    }

    const gpu::Device* device;
    Executor executor;
    Resources resources;
    ShortFrame short_frame;  // with Passes::frame
    Moment moment;           // the next frame, or the last one
    Plan plan;               // its images and buffers; passes after the first frame
    Progress progress;
    Tabulated tabulated;
    Listing listing;
    PassWatcher watcher;  // empty: no watcher

    // Sets the view of the next frames and the one before it, and makes what their passes need.
    void look(const View& view, const View& before) {
        moment.look(view, before);
        moment.filtered = filters(moment.settings);
        plan = planned_resources(moment);
        resources.provide(plan);
    }

    // Takes a view for the next frames. follows: it continues the one before.
    void take(const scene::GBuffer& new_view, const Settings& settings, bool follows);
    // The same for Passes::frame.
    void take_short(const scene::GBuffer& new_view, const Settings& settings, bool follows) {
        require_guard(new_view, settings);
        require_sizes(new_view, moment.given.extent);
        moment.settings = settings;
        short_frame.take(new_view, settings, follows);
    }
    // Decides what the next frame runs.
    void decide();
    [[nodiscard]] Frame collect() const;
    [[nodiscard]] Work work(std::span<const float> convergence) const;
    // The history into which the samples are blended.
    [[nodiscard]] HistoryTexels history() const {
        return history_in(resources.image(moment.moves_history() ? "history_reprojected" : "history_before"));
    }
};

void AmbientOcclusion::Impl::take(const scene::GBuffer& new_view, const Settings& settings, bool follows) {
    require_guard(new_view, settings);
    require_layers(new_view, settings);
    (void)scene::frame_of(new_view);
    require_centred(new_view);
    require_sizes(new_view, moment.given.extent);
    moment.settings = settings;
    moment.converted = new_view.stored ? std::optional(new_view.stored->encoding) : std::nullopt;
    moment.has_normals = !new_view.normal.empty();
    moment.has_positions = !new_view.previous_position.empty();
    const View view{new_view.camera, moment.given.extent, new_view.border};
    look(view, follows ? View(moment.given) : view);
    upload(new_view, view.extent, true, resources);
    tabulated.take(settings);
}

void AmbientOcclusion::Impl::decide() {
    moment.new_view = progress.first_of_view();
    moment.moved = progress.history_lags();
    moment.settled = progress.settled();
    // Before the first frame nothing is known that a list could leave out.
    const bool known = progress.frames_since_cut() > 0;
    moment.listed = selects_tiles(moment.settings) && known && listing.due(moment.moved);
    moment.tabulated = tabulated.missing();
    plan.passes = planned_passes(moment, plan);
}

Frame AmbientOcclusion::Impl::collect() const {
    const Settings& settings = moment.settings;
    const bool mapped = moment.maps_images();
    Frame frame;
    if (shows_alone(settings)) {
        frame.occlusion = resources.image(mapped ? "mapped" : "filtered").download();
        frame.convergence = frame.kept = std::vector<float>(frame.occlusion.size(), 0.0F);
    } else {
        HistoryTexels result = history_in(resources.image("history_after"));
        frame.occlusion = mapped ? resources.image("mapped").download() : std::move(result.occlusion);
        frame.convergence = std::move(result.samples);
        frame.kept = history().samples;
    }
    const char* filtered = moment.half() ? "upsampled" : mapped ? "filtered_mapped" : "filtered";
    frame.filtered =
        moment.filtered || moment.half() ? resources.image(filtered).download() : frame.occlusion;
    for (float& value : frame.convergence) value = std::min(value / settings.weight_max, 1.0F);
    frame.work = work(frame.convergence);
    const View& given = moment.given;
    if (moment.half()) {
        frame.occlusion = moment.filtered ? expanded(frame.occlusion, given.extent) : frame.filtered;
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
    const Settings& settings = moment.settings;
    const bool selected = moment.listed;
    const std::uint32_t samples =
        samples_taken(method_named(settings.method), std::max(settings.samples, settings.samples_converged),
                      settings.own.steps);
    Work total = summed(resources.buffer("tile_states_after").as<const TileState>(), moment.view.extent,
                        moment.unshaded_band(), samples, selected);
    const SelectedTiles tiles = counts_in(resources.buffer("tile_lists"));
    total.tiles_shaded = selected ? tiles.shaded : total.tiles;
    if (moment.filtered) total.tiles_filtered = selected ? tiles.filtered : total.tiles;
    total.tiles_blank = tiles.background;
    total.tiles_settled = tiles.settled;
    total.tiles_unfiltered = tiles.filtered_enough;
    if (settings.filter == Filter::convergence) {
        for (const float value : convergence) total.converged += value >= settings.c_adaptive ? 1 : 0;
    }
    return total;
}

AmbientOcclusion::AmbientOcclusion(const gpu::Device& device, const scene::PassLibrary& passes,
                                   gpu::Extent extent)
    : impl_(base::make_hidden<Impl>(device, passes, extent)) {}

void AmbientOcclusion::begin(const scene::GBuffer& view, const Settings& settings) {
    Impl& impl = *impl_;
    validate(settings);
    if (settings.passes == Passes::frame) {
        impl.take_short(view, settings, false);
        return impl.progress.begin();
    }
    impl.take(view, settings, false);
    impl.tabulated.restart();
    impl.listing.restart();
    impl.resources.restart(impl.plan);
    impl.progress.begin();
}

void AmbientOcclusion::advance(const scene::GBuffer& view) {
    Impl& impl = *impl_;
    if (!impl.progress.has_view()) throw std::logic_error("no view: begin() must come before advance()");
    const bool resized = view.extent != impl.moment.given.extent;
    if (resized) impl.moment.given.extent = view.extent;
    const Settings settings = impl.moment.settings;
    if (settings.passes == Passes::frame) return impl.take_short(view, settings, true);
    if (resized || !view.camera.previous_from_current) return begin(view, settings);
    impl.take(view, settings, true);
    impl.progress.advance();
}

void AmbientOcclusion::watch(PassWatcher watcher) {
    impl_->watcher = std::move(watcher);
}

Frame AmbientOcclusion::next(int repeat) {
    Impl& impl = *impl_;
    if (!impl.progress.has_view()) throw std::logic_error("no view: begin() must come before next()");
    if (repeat < 1) throw std::invalid_argument(fmt::format("repeat {}: expected 1 or more", repeat));
    if (impl.moment.settings.passes == Passes::frame) return impl.short_frame.next(repeat, impl.watcher);
    impl.decide();
    // Each run reads the same history and writes the same images, so a repeated run changes nothing.
    const std::vector<Step> steps = impl.executor.steps(impl.plan.passes, impl.resources);
    std::vector<PassTime> times =
        run(*impl.device, steps, {}, repeat, [&] { impl.resources.refill(impl.plan); }, impl.watcher);
    Frame frame = impl.collect();
    frame.memory_bytes = memory_of(steps);
    frame.times = std::move(times);
    const SelectedTiles found = counts_in(impl.resources.buffer("tile_lists"));
    impl.listing.advance(impl.moment.listed, found, frame.work.tiles);
    impl.progress.count_frame();
    impl.tabulated.advance();
    impl.resources.exchange(impl.plan.exchanged);
    impl.moment.odd = !impl.moment.odd;
    return frame;
}

}  // namespace gloam::effect
