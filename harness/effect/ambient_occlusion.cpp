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
          filter_pipeline(convergence_filter(the_device, passes)),
          view{.extent = size},
          depth(the_device, size, r32f),
          normal(the_device, size, rgba32f),
          before(the_device, size, rgba32f),
          after(the_device, size, rgba32f),
          half_filtered(the_device, size, rgba32f),
          filtered(the_device, size, rgba32f),
          tiles(the_device, tiles_of(size) * sizeof(TileWork)) {}

    const gpu::Device* device;
    scene::PassLibrary library;
    gpu::ComputePipeline normals_pipeline;
    gpu::ComputePipeline filter_pipeline;
    std::map<Method, gpu::ComputePipeline> occlusion_pipelines;
    View view;
    Settings settings;
    bool begun = false;
    bool reconstruct_normals = false;
    gpu::Image depth;
    gpu::Image normal;
    gpu::Image before;  // history of the last frame
    gpu::Image after;   // history of this frame
    gpu::Image half_filtered;
    gpu::Image filtered;
    gpu::Buffer tiles;
    NormalParameters normal_constants{};
    OcclusionParameters occlusion_constants{};
    FilterParameters filter_x_constants{};
    FilterParameters filter_y_constants{};

    [[nodiscard]] std::vector<Step> steps() const;
    [[nodiscard]] std::vector<PassTime> run(const std::vector<Step>& passes, int repeat) const;
    [[nodiscard]] Frame collect() const;
};

std::vector<Step> AmbientOcclusion::Impl::steps() const {
    std::vector<Step> passes;
    if (reconstruct_normals) {
        passes.push_back(
            {"normals_from_depth", &normals_pipeline, {depth, normal}, bytes_of(normal_constants)});
    }
    passes.push_back({"ambient_occlusion",
                      &occlusion_pipelines.at(settings.method),
                      {depth, normal, before, after, tiles},
                      bytes_of(occlusion_constants)});
    if (settings.filter) {
        passes.push_back(
            {"filter_x", &filter_pipeline, {depth, after, half_filtered}, bytes_of(filter_x_constants)});
        passes.push_back(
            {"filter_y", &filter_pipeline, {depth, half_filtered, filtered}, bytes_of(filter_y_constants)});
    }
    return passes;
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
    const std::vector<float> history = after.download();
    Frame frame{.occlusion = channel(history, 0), .convergence = channel(history, 1)};
    frame.filtered = settings.filter ? channel(filtered.download(), 0) : frame.occlusion;
    for (float& value : frame.convergence) value = std::min(value / settings.weight_max, 1.0F);

    std::vector<TileWork> counts(tiles.size() / sizeof(TileWork));
    std::memcpy(counts.data(), tiles.bytes().data(), tiles.size());
    frame.work = summed(counts);
    if (settings.filter) {
        for (const float value : frame.convergence)
            frame.work.converged += value >= settings.c_adaptive ? 1 : 0;
    }
    return frame;
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
    require_size("depth", view.depth.size(), impl.view.extent);
    if (!view.normal.empty()) require_size("normals", view.normal.size(), impl.view.extent);
    if (!impl.occlusion_pipelines.contains(settings.method)) {
        impl.occlusion_pipelines.emplace(settings.method,
                                         ambient_occlusion(*impl.device, impl.library, settings.method));
    }
    impl.view.camera = view.camera;
    impl.settings = settings;
    impl.reconstruct_normals = view.normal.empty();
    impl.depth.upload(view.depth);
    if (!impl.reconstruct_normals) impl.normal.upload(texels_of(view.normal));
    impl.before.upload(std::vector<float>(4 * pixels_of(impl.view.extent), 0.0F));
    impl.normal_constants = normal_parameters(impl.view);
    impl.occlusion_constants = occlusion_parameters(impl.view, settings);
    impl.filter_x_constants = filter_parameters(impl.view, settings, {1, 0});
    impl.filter_y_constants = filter_parameters(impl.view, settings, {0, 1});
    impl.begun = true;
}

Frame AmbientOcclusion::next(int repeat) {
    Impl& impl = *impl_;
    if (!impl.begun) throw std::logic_error("no view: begin() must come before next()");
    if (repeat < 1) throw std::invalid_argument(fmt::format("repeat {}: expected 1 or more", repeat));
    std::vector<PassTime> times = impl.run(impl.steps(), repeat);
    Frame frame = impl.collect();
    frame.times = std::move(times);
    impl.reconstruct_normals = false;
    std::swap(impl.before, impl.after);
    return frame;
}

}  // namespace gloam::effect
