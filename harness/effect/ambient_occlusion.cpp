// SPDX-License-Identifier: MIT
#include "effect/ambient_occlusion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <utility>

#include "effect/internal/frame_images.hpp"
#include "effect/internal/pipelines.hpp"
#include "effect/internal/prepared_image.hpp"
#include "effect/internal/steps.hpp"
#include "effect/internal/work.hpp"
#include "scene/guard_band.hpp"

namespace gloam::effect {
namespace {

// A view without the band that the settings ask for.
void require_guard(const scene::GBuffer& view, const Settings& settings) {
    const gpu::Extent none;
    const double guard = double{settings.guard};
    if (view.border != none || scene::guard_border(view.extent, guard) == none) return;
    throw std::invalid_argument(fmt::format("guard {:g}: the view has no guard band", guard));
}

// A view with fewer layers than the settings ask for.
void require_layers(const scene::GBuffer& view, const Settings& settings) {
    if (view.layers.size() + 1 >= settings.layers) return;
    throw std::invalid_argument(fmt::format("layers {}: the view has {}, the first among them",
                                            settings.layers, view.layers.size() + 1));
}

}  // namespace

struct AmbientOcclusion::Impl {
    Impl(const gpu::Device& the_device, const scene::PassLibrary& passes, gpu::Extent size)
        : device(&the_device),
          pipelines(the_device, passes),
          nothing(the_device, {1, 1}, gpu::Format::rgba32f),
          method(the_device, sizeof(MethodParameters)),
          prepared(the_device, passes) {
        allocate(size);
    }

    const gpu::Device* device;
    Pipelines pipelines;
    View view;
    View previous_view;
    Settings settings;
    bool begun = false;
    bool reconstruct_normals = false;
    bool moved = false;  // the history has not followed the last view yet
    gpu::Image nothing;  // for bindings that are not read
    gpu::Buffer method;  // MethodParameters
    PreparedImage prepared;
    std::optional<FrameImages> images;
    NormalParameters normal_constants{};
    ReprojectionParameters reprojection_constants{};
    OcclusionParameters occlusion_constants{};
    FilterParameters filter_x_constants{};
    FilterParameters filter_y_constants{};
    RemapParameters remap_constants{};

    void allocate(gpu::Extent size);
    void take(const scene::GBuffer& new_view);
    [[nodiscard]] Program program() const;
    [[nodiscard]] const gpu::Image& history() const { return moved ? images->reprojected : images->before; }
    [[nodiscard]] std::vector<Step> steps();
    void append_remap(std::vector<Step>& passes);
    [[nodiscard]] Frame collect() const;
    [[nodiscard]] Work work(std::span<const float> convergence) const;
};

void AmbientOcclusion::Impl::allocate(gpu::Extent size) {
    view.extent = size;
    images.emplace(*device, size, settings.precision);
}

// The images and constants of a view. Positions of the frame before matter only when the history follows
// them.
void AmbientOcclusion::Impl::take(const scene::GBuffer& new_view) {
    require_guard(new_view, settings);
    require_layers(new_view, settings);
    (void)scene::frame_of(new_view);
    images->take(*device, new_view);
    view.camera = new_view.camera;
    view.border = new_view.border;
    reconstruct_normals = new_view.normal.empty();
    if (remaps(settings)) images->map(*device);
    normal_constants = normal_parameters(view);
    occlusion_constants = occlusion_parameters(view, settings);
    method.as<MethodParameters>()[0] = method_parameters(settings);
    prepared.take(view, settings);
    filter_x_constants = filter_parameters(view, settings, {1, 0});
    filter_y_constants = filter_parameters(view, settings, {0, 1});
    remap_constants = remap_parameters(view, settings);
}

Program AmbientOcclusion::Impl::program() const {
    return {.method = settings.method,
            .precision = settings.precision,
            .moving_objects = moved && images->previous_position.has_value(),
            .layers = settings.layers};
}

std::vector<Step> AmbientOcclusion::Impl::steps() {
    const gpu::Image& positions = images->previous_position ? *images->previous_position : nothing;
    std::vector<Step> passes;
    if (reconstruct_normals) {
        passes.push_back({"normals_from_depth",
                          &pipelines.normals(),
                          {images->depth, images->normal},
                          bytes_of(normal_constants)});
    }
    if (moved) {
        passes.push_back({"reproject",
                          &pipelines.reprojection(program()),
                          {images->depth, positions, images->before, images->reprojected},
                          bytes_of(reprojection_constants)});
    }
    const gpu::Image& layers = images->layers ? *images->layers : nothing;
    prepared.append_steps({images->depth, images->normal, history(), method, layers}, passes);
    passes.push_back({"ambient_occlusion",
                      &pipelines.occlusion(program()),
                      {images->depth, images->normal, history(), images->after, images->tiles, positions,
                       method, prepared.image_or(nothing), layers},
                      bytes_of(occlusion_constants)});
    if (filters(settings)) {
        passes.push_back({"filter_x",
                          &pipelines.filter(settings.filter, settings.precision),
                          {images->depth, images->after, images->half_filtered, images->normal},
                          bytes_of(filter_x_constants)});
        passes.push_back({"filter_y",
                          &pipelines.filter(settings.filter, HistoryPrecision::float32),
                          {images->depth, images->half_filtered, images->filtered, images->normal},
                          bytes_of(filter_y_constants)});
    }
    append_remap(passes);
    return passes;
}

// What is shown, of the history and of the filter's result.
void AmbientOcclusion::Impl::append_remap(std::vector<Step>& passes) {
    if (!remaps(settings)) return;
    passes.push_back({"remap",
                      &pipelines.remapping(settings.precision),
                      {images->depth, images->after, *images->mapped},
                      bytes_of(remap_constants)});
    if (!filters(settings)) return;
    passes.push_back({"remap_filtered",
                      &pipelines.remapping(HistoryPrecision::float32),
                      {images->depth, images->filtered, *images->filtered_mapped},
                      bytes_of(remap_constants)});
}

Frame AmbientOcclusion::Impl::collect() const {
    const std::vector<float> result = images->after.download();
    const bool mapped = remaps(settings);
    Frame frame{.occlusion = channel(mapped ? images->mapped->download() : result, 0),
                .convergence = channel(result, 1),
                .kept = channel(history().download(), 1)};
    const gpu::Image& filtered = mapped ? *images->filtered_mapped : images->filtered;
    frame.filtered = filters(settings) ? channel(filtered.download(), 0) : frame.occlusion;
    for (float& value : frame.convergence) value = std::min(value / settings.weight_max, 1.0F);
    frame.work = work(frame.convergence);

    const scene::GBuffer shape{.extent = view.extent, .border = view.border};
    frame.extent = scene::frame_of(shape);
    for (std::vector<float>* image : {&frame.occlusion, &frame.filtered, &frame.convergence, &frame.kept})
        *image = scene::cropped(shape, *image);
    return frame;
}

Work AmbientOcclusion::Impl::work(std::span<const float> convergence) const {
    std::vector<TileWork> counts(images->tiles.size() / sizeof(TileWork));
    std::memcpy(counts.data(), images->tiles.bytes().data(), images->tiles.size());
    Work total = summed(counts);
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
    const bool reformat = settings.precision != impl.settings.precision;
    impl.settings = settings;
    if (reformat) impl.allocate(impl.view.extent);
    impl.take(view);
    impl.moved = false;
    impl.images->before.upload(std::vector<float>(4 * pixels_of(impl.view.extent), 0.0F));
    impl.begun = true;
}

void AmbientOcclusion::advance(const scene::GBuffer& view) {
    Impl& impl = *impl_;
    if (!impl.begun) throw std::logic_error("no view: begin() must come before advance()");
    const bool resized = view.extent != impl.view.extent;
    if (resized) impl.allocate(view.extent);
    if (resized || !view.camera.previous_from_current) return begin(view, impl.settings);
    impl.previous_view = impl.view;
    impl.take(view);
    impl.reprojection_constants = reprojection_parameters(impl.view, impl.previous_view, impl.settings);
    impl.moved = true;
}

Frame AmbientOcclusion::next(int repeat) {
    Impl& impl = *impl_;
    if (!impl.begun) throw std::logic_error("no view: begin() must come before next()");
    if (repeat < 1) throw std::invalid_argument(fmt::format("repeat {}: expected 1 or more", repeat));
    // Each run reads the same history and writes the same images, so running again changes nothing.
    const std::vector<Step> steps = impl.steps();
    std::vector<PassTime> times = run(*impl.device, steps, groups_for(impl.view.extent), repeat);
    Frame frame = impl.collect();
    frame.memory_bytes = memory_of(steps);
    frame.times = std::move(times);
    impl.reconstruct_normals = false;
    impl.moved = false;
    std::swap(impl.images->before, impl.images->after);
    return frame;
}

}  // namespace gloam::effect
