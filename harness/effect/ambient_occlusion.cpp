// SPDX-License-Identifier: MIT
#include "effect/ambient_occlusion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "effect/internal/passes.hpp"
#include "effect/internal/work.hpp"
#include "gpu/commands.hpp"
#include "scene/guard_band.hpp"

namespace gloam::effect {
namespace {

using enum gpu::Format;

// A pass, ready to be recorded.
struct Step {
    std::string name;
    const gpu::ComputePipeline* pipeline = nullptr;
    std::vector<gpu::Resource> resources;
    std::span<const std::byte> parameters;
};

template <class Parameters>
std::span<const std::byte> bytes_of(const Parameters& parameters) {
    return std::as_bytes(std::span(&parameters, 1));
}

std::size_t pixels_of(gpu::Extent extent) {
    return std::size_t{extent.width} * extent.height;
}

std::size_t tiles_of(gpu::Extent extent) {
    const auto groups = groups_for(extent);
    return std::size_t{groups[0]} * groups[1];
}

void require_size(const char* what, std::size_t found, gpu::Extent extent) {
    if (found == pixels_of(extent)) return;
    throw std::invalid_argument(
        fmt::format("{}: {} pixels, expected {} x {}", what, found, extent.width, extent.height));
}

// A view without the band that the settings ask for.
void require_guard(const scene::GBuffer& view, const Settings& settings) {
    const gpu::Extent none;
    const double guard = double{settings.guard};
    if (view.border != none || scene::guard_border(view.extent, guard) == none) return;
    throw std::invalid_argument(fmt::format("guard {:g}: the view has no guard band", guard));
}

std::vector<float> texels_of(std::span<const glm::vec3> normals) {
    std::vector<float> texels;
    texels.reserve(4 * normals.size());
    for (const glm::vec3& n : normals) texels.insert(texels.end(), {n.x, n.y, n.z, 0.0F});
    return texels;
}

std::vector<float> channel(std::span<const float> texels, std::size_t which) {
    std::vector<float> values(texels.size() / 4);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = texels[4 * i + which];
    return values;
}

}  // namespace

struct AmbientOcclusion::Impl {
    Impl(const gpu::Device& the_device, const scene::PassLibrary& passes, gpu::Extent size)
        : device(&the_device),
          library(passes),
          normals_pipeline(normals_from_depth(the_device, passes)),
          nothing(the_device, {1, 1}, rgba32f),
          method(the_device, sizeof(MethodParameters)) {
        allocate(size);
    }

    // Everything of the size of the image.
    struct Images {
        Images(const gpu::Device& device, gpu::Extent size, gpu::Format history)
            : depth(device, size, r32f),
              normal(device, size, rgba32f),
              before(device, size, history),
              reprojected(device, size, history),
              after(device, size, history),
              half_filtered(device, size, rgba32f),
              filtered(device, size, rgba32f),
              tiles(device, tiles_of(size) * sizeof(TileWork)) {}

        gpu::Image depth;
        gpu::Image normal;
        gpu::Image before;       // history of the last frame, at its pixels
        gpu::Image reprojected;  // the same at the pixels of this frame, when the view has moved
        gpu::Image after;        // history of this frame
        gpu::Image half_filtered;
        gpu::Image filtered;
        gpu::Buffer tiles;
        std::optional<gpu::Image> previous_position;
        std::optional<gpu::Image> mapped;           // what is shown of the history, where it is mapped at all
        std::optional<gpu::Image> filtered_mapped;  // and of the filter's result
    };

    const gpu::Device* device;
    scene::PassLibrary library;
    gpu::ComputePipeline normals_pipeline;
    std::map<std::pair<Filter, HistoryPrecision>, gpu::ComputePipeline>
        filter_pipelines;                                              // by what they read
    std::map<HistoryPrecision, gpu::ComputePipeline> remap_pipelines;  // likewise
    std::map<Program, gpu::ComputePipeline> occlusion_pipelines;
    std::map<Program, gpu::ComputePipeline> reprojection_pipelines;
    View view;
    View previous_view;
    Settings settings;
    bool begun = false;
    bool reconstruct_normals = false;
    bool moved = false;  // the history has not followed the last view yet
    gpu::Image nothing;  // for bindings that are not read
    gpu::Buffer method;  // MethodParameters
    std::optional<Images> images;
    NormalParameters normal_constants{};
    ReprojectionParameters reprojection_constants{};
    OcclusionParameters occlusion_constants{};
    FilterParameters filter_x_constants{};
    FilterParameters filter_y_constants{};
    RemapParameters remap_constants{};

    void allocate(gpu::Extent size);
    void take(const scene::GBuffer& new_view);
    void prepare_pipelines();
    [[nodiscard]] Program program() const;
    [[nodiscard]] const gpu::Image& history() const { return moved ? images->reprojected : images->before; }
    [[nodiscard]] std::vector<Step> steps() const;
    void append_remap(std::vector<Step>& passes) const;
    [[nodiscard]] std::vector<PassTime> run(const std::vector<Step>& passes, int repeat) const;
    [[nodiscard]] Frame collect() const;
    [[nodiscard]] Work work(std::span<const float> convergence) const;
};

void AmbientOcclusion::Impl::allocate(gpu::Extent size) {
    view.extent = size;
    images.emplace(*device, size, settings.precision == HistoryPrecision::float16 ? rgba16f : rgba32f);
}

// The images and constants of a view. Positions of the frame before matter only when the history follows
// them.
void AmbientOcclusion::Impl::take(const scene::GBuffer& new_view) {
    require_size("depth", new_view.depth.size(), view.extent);
    if (!new_view.normal.empty()) require_size("normals", new_view.normal.size(), view.extent);
    require_guard(new_view, settings);
    (void)scene::frame_of(new_view);
    view.camera = new_view.camera;
    view.border = new_view.border;
    reconstruct_normals = new_view.normal.empty();
    images->depth.upload(new_view.depth);
    if (!reconstruct_normals) images->normal.upload(texels_of(new_view.normal));
    images->previous_position.reset();
    if (!new_view.previous_position.empty()) {
        require_size("previous positions", new_view.previous_position.size(), view.extent);
        images->previous_position.emplace(*device, view.extent, rgba32f);
        images->previous_position->upload(texels_of(new_view.previous_position));
    }
    if (remaps(settings) && !images->mapped) {
        images->mapped.emplace(*device, view.extent, rgba32f);
        images->filtered_mapped.emplace(*device, view.extent, rgba32f);
    }
    normal_constants = normal_parameters(view);
    occlusion_constants = occlusion_parameters(view, settings);
    method.as<MethodParameters>()[0] = method_parameters(settings);
    filter_x_constants = filter_parameters(view, settings, {1, 0});
    filter_y_constants = filter_parameters(view, settings, {0, 1});
    remap_constants = remap_parameters(view, settings);
}

Program AmbientOcclusion::Impl::program() const {
    return {.method = settings.method,
            .precision = settings.precision,
            .moving_objects = moved && images->previous_position.has_value()};
}

void AmbientOcclusion::Impl::prepare_pipelines() {
    const Program now = program();
    if (!occlusion_pipelines.contains(now)) {
        occlusion_pipelines.emplace(now, ambient_occlusion(*device, library, now));
    }
    if (moved && !reprojection_pipelines.contains(now)) {
        reprojection_pipelines.emplace(now, reproject(*device, library, now));
    }
    for (const HistoryPrecision precision : {settings.precision, HistoryPrecision::float32}) {
        if (filters(settings) && !filter_pipelines.contains({settings.filter, precision})) {
            filter_pipelines.emplace(std::pair(settings.filter, precision),
                                     spatial_filter(*device, library, settings.filter, precision));
        }
        if (remaps(settings) && !remap_pipelines.contains(precision)) {
            remap_pipelines.emplace(precision, remap(*device, library, precision));
        }
    }
}

std::vector<Step> AmbientOcclusion::Impl::steps() const {
    const gpu::Image& positions = images->previous_position ? *images->previous_position : nothing;
    std::vector<Step> passes;
    if (reconstruct_normals) {
        passes.push_back({"normals_from_depth",
                          &normals_pipeline,
                          {images->depth, images->normal},
                          bytes_of(normal_constants)});
    }
    if (moved) {
        passes.push_back({"reproject",
                          &reprojection_pipelines.at(program()),
                          {images->depth, positions, images->before, images->reprojected},
                          bytes_of(reprojection_constants)});
    }
    passes.push_back(
        {"ambient_occlusion",
         &occlusion_pipelines.at(program()),
         {images->depth, images->normal, history(), images->after, images->tiles, positions, method},
         bytes_of(occlusion_constants)});
    if (filters(settings)) {
        passes.push_back({"filter_x",
                          &filter_pipelines.at({settings.filter, settings.precision}),
                          {images->depth, images->after, images->half_filtered, images->normal},
                          bytes_of(filter_x_constants)});
        passes.push_back({"filter_y",
                          &filter_pipelines.at({settings.filter, HistoryPrecision::float32}),
                          {images->depth, images->half_filtered, images->filtered, images->normal},
                          bytes_of(filter_y_constants)});
    }
    append_remap(passes);
    return passes;
}

// What is shown, of the history and of the filter's result.
void AmbientOcclusion::Impl::append_remap(std::vector<Step>& passes) const {
    if (!remaps(settings)) return;
    passes.push_back({"remap",
                      &remap_pipelines.at(settings.precision),
                      {images->depth, images->after, *images->mapped},
                      bytes_of(remap_constants)});
    if (!filters(settings)) return;
    passes.push_back({"remap_filtered",
                      &remap_pipelines.at(HistoryPrecision::float32),
                      {images->depth, images->filtered, *images->filtered_mapped},
                      bytes_of(remap_constants)});
}

// Each run reads the same history and writes the same images, so running again changes nothing.
std::vector<PassTime> AmbientOcclusion::Impl::run(const std::vector<Step>& passes, int repeat) const {
    std::vector<std::vector<double>> times(passes.size());
    for (int i = 0; i < repeat; ++i) {
        gpu::Commands commands(*device);
        commands.timestamp();
        for (const Step& pass : passes) {
            commands.dispatch(*pass.pipeline, pass.resources, groups_for(view.extent), pass.parameters);
            commands.timestamp();
        }
        commands.submit();
        const std::vector<double> readings = commands.times_ms();
        for (std::size_t p = 0; p < passes.size(); ++p) times[p].push_back(readings[p + 1] - readings[p]);
    }
    std::vector<PassTime> medians;
    for (std::size_t p = 0; p < passes.size(); ++p) medians.push_back({passes[p].name, median(times[p])});
    return medians;
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
    impl.prepare_pipelines();
    std::vector<PassTime> times = impl.run(impl.steps(), repeat);
    Frame frame = impl.collect();
    frame.times = std::move(times);
    impl.reconstruct_normals = false;
    impl.moved = false;
    std::swap(impl.images->before, impl.images->after);
    return frame;
}

}  // namespace gloam::effect
