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
#include "scene/gbuffer.hpp"

namespace gloam::effect {

// The state of the effect: the last view, images and histories, and what the next frame runs.
struct AmbientOcclusion::Impl {
    Impl(const gpu::Device& the_device, const scene::PassLibrary& passes, gpu::Extent size)
        : device(&the_device),
          executor(the_device, passes),
          resources(the_device),
          short_frame(the_device, passes) {
        moment.shows_unfiltered = true;
        look({.camera = {}, .extent = size, .border = {}}, {});
    }

    const gpu::Device* device;
    Executor executor;
    Resources resources;
    ShortFrame short_frame;  // with Passes::frame
    Moment moment;           // the next frame, or the last one
    Plan plan;               // its images and buffers; passes after the first frame
    Progress progress;
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
        require_sizes(new_view, moment.view.extent);
        moment.settings = settings;
        short_frame.take(new_view, settings, follows);
    }
    // Decides what the next frame runs.
    void decide();
    [[nodiscard]] Frame collect() const;
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
    require_sizes(new_view, moment.view.extent);
    moment.settings = settings;
    moment.converted = new_view.stored ? std::optional(new_view.stored->encoding) : std::nullopt;
    moment.has_normals = !new_view.normal.empty();
    moment.has_positions = !new_view.previous_position.empty();
    const View view{new_view.camera, moment.view.extent, new_view.border};
    look(view, follows ? View(moment.view) : view);
    upload(new_view, view.extent, true, resources);
}

void AmbientOcclusion::Impl::decide() {
    moment.new_view = progress.first_of_view();
    moment.moved = progress.history_lags();
    plan.passes = planned_passes(moment, plan,
                                 [this](const PassSource& source) { return executor.interface_of(source); });
}

namespace {

// Mean over the pixels with a surface; k_1 where nothing tells which they are.
double samples_asked(const Frame& frame, const Settings& settings) {
    const auto whole = [&](std::uint32_t samples) {
        return static_cast<double>(samples_taken(method_named(settings.method), samples, settings.own.steps));
    };
    double sum = 0.0;
    double surfaces = 0.0;
    for (std::size_t i = 0; i < frame.kept.size(); ++i) {
        if (!(frame.convergence[i] > 0.0F)) continue;
        const bool converged = frame.kept[i] / settings.weight_max >= settings.c_spatial;
        sum += whole(converged ? settings.samples_converged : settings.samples);
        surfaces += 1.0;
    }
    return surfaces > 0.0 ? sum / surfaces : whole(settings.samples);
}

}  // namespace

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
    const char* filtered = mapped ? "filtered_mapped" : "filtered";
    frame.filtered = moment.filtered ? resources.image(filtered).download() : frame.occlusion;
    for (float& value : frame.convergence) value = std::min(value / settings.weight_max, 1.0F);
    const scene::GBuffer shape{.extent = moment.view.extent, .border = moment.view.border};
    frame.extent = scene::frame_of(shape);
    for (std::vector<float>* image : {&frame.occlusion, &frame.filtered, &frame.convergence, &frame.kept})
        *image = scene::cropped(shape, *image);
    frame.samples = samples_asked(frame, settings);
    return frame;
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
    impl.resources.restart(impl.plan);
    impl.progress.begin();
}

void AmbientOcclusion::advance(const scene::GBuffer& view) {
    Impl& impl = *impl_;
    if (!impl.progress.has_view()) throw std::logic_error("no view: begin() must come before advance()");
    const bool resized = view.extent != impl.moment.view.extent;
    if (resized) impl.moment.view.extent = view.extent;
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
    std::vector<PassTime> times = run(*impl.device, steps, {}, repeat, impl.watcher);
    Frame frame = impl.collect();
    frame.memory_bytes = memory_of(steps);
    frame.times = std::move(times);
    impl.progress.count_frame();
    impl.resources.exchange(impl.plan.exchanged);
    return frame;
}

}  // namespace gloam::effect
