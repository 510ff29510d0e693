// SPDX-License-Identifier: MIT
#include "effect/ambient_occlusion.hpp"

#include <array>
#include <cmath>
#include <span>
#include <stdexcept>

#include "effect/internal/parameters.hpp"
#include "effect/internal/timed_passes.hpp"
#include "effect/internal/work_records.hpp"

namespace gloam::effect {
namespace {

using gpu::BindingKind;
using gpu::Format;
using gpu::Image;

constexpr std::uint32_t tile = 8;  // pixels on each side of a work group

void require(bool condition, const char* message) {
    if (!condition) throw std::invalid_argument(message);
}

void check(const Settings& s, double radius) {
    require(radius > 0.0 && std::isfinite(radius), "ambient occlusion: expected a radius > 0");
    require(s.samples >= 1 && s.samples_converged >= 0, "ambient occlusion: expected at least 1 sample a frame");
    require(s.weight_max > 0.0 && s.weight_max <= 1 << 20, "ambient occlusion: expected weight_max in (0, 2^20]");
    require(s.half_width >= 0 && s.half_width <= 64, "ambient occlusion: expected a filter of half width 0 to 64");
}

template <class T>
std::span<const std::byte> bytes_of(const T& value) {
    return std::as_bytes(std::span(&value, 1));
}

gpu::ComputePipeline make_pipeline(const gpu::Device& device, const shader::Spirv& spirv, std::size_t images,
                                   std::size_t buffers, std::size_t push_constant_bytes) {
    std::vector<BindingKind> bindings(images, BindingKind::storage_image);
    bindings.insert(bindings.end(), buffers, BindingKind::storage_buffer);
    return {device,
            {.spirv = spirv,
             .bindings = bindings,
             .push_constant_bytes = static_cast<std::uint32_t>(push_constant_bytes)}};
}

std::array<std::uint32_t, 3> tiles_of(gpu::Extent extent) {
    return {(extent.width + tile - 1) / tile, (extent.height + tile - 1) / tile, 1};
}

std::vector<float> to_texels(const std::vector<glm::vec3>& vectors) {
    std::vector<float> texels;
    texels.reserve(vectors.size() * 4);
    for (const glm::vec3& v : vectors) texels.insert(texels.end(), {v.x, v.y, v.z, 0.0F});
    return texels;
}

}  // namespace

struct AmbientOcclusion::Impl {
    Impl(const gpu::Device& on, const scene::PassLibrary& passes, gpu::Extent size, const Method& method,
         const Settings& with, double influence)
        : device(on),
          extent(size),
          settings(with),
          radius(influence),
          depth(on, size, Format::r32f),
          normal(on, size, Format::rgba32f),
          history{Image(on, size, Format::rgba32f), Image(on, size, Format::rgba32f)},
          raw(on, size, Format::r32f),
          filtered_x(on, size, Format::r32f),
          filtered(on, size, Format::r32f),
          records(on, sizeof(WorkRecord) * tiles_of(size)[0] * tiles_of(size)[1]),
          normals(make_pipeline(on, passes.compile("normals_from_depth.comp"), 2, 0, sizeof(NormalParameters))),
          gather(make_pipeline(on, passes.compile(method.pass), 5, 0, sizeof(OcclusionParameters))),
          gather_and_count(make_pipeline(on, passes.compile(method.pass, {"GLOAM_COUNT_WORK"}), 5, 1,
                                         sizeof(OcclusionParameters))),
          filter(make_pipeline(on, passes.compile("convergence_filter.comp"), 4, 0, sizeof(FilterParameters))) {}

    void upload(const scene::GBuffer& gbuffer);
    [[nodiscard]] std::vector<Pass> passes(const scene::GBuffer& gbuffer, bool count) const;
    [[nodiscard]] Pass normals_pass(const ViewParameters& view, bool orthographic) const;
    [[nodiscard]] Pass gather_pass(const ViewParameters& view, bool orthographic, bool count) const;
    [[nodiscard]] Pass filter_pass(const ViewParameters& view, bool orthographic, glm::ivec2 axis) const;

    const gpu::Device& device;
    gpu::Extent extent;
    Settings settings;
    double radius;

    Image depth;
    Image normal;
    std::array<Image, 2> history;
    std::size_t newest = 0;  // which of the two the next frame writes
    Image raw;
    Image filtered_x;
    Image filtered;
    gpu::Buffer records;

    gpu::ComputePipeline normals;
    gpu::ComputePipeline gather;
    gpu::ComputePipeline gather_and_count;
    gpu::ComputePipeline filter;
};

void AmbientOcclusion::Impl::upload(const scene::GBuffer& gbuffer) {
    depth.upload(gbuffer.depth);
    if (!gbuffer.normal.empty()) normal.upload(to_texels(gbuffer.normal));
}

Pass AmbientOcclusion::Impl::normals_pass(const ViewParameters& view, bool orthographic) const {
    return {"normals", [this, parameters = NormalParameters{view, orthographic}](gpu::Commands& commands) {
                const std::array<gpu::Resource, 2> resources{depth, normal};
                commands.dispatch(normals, resources, tiles_of(extent), bytes_of(parameters));
            }};
}

Pass AmbientOcclusion::Impl::gather_pass(const ViewParameters& view, bool orthographic, bool count) const {
    const auto f = [](double x) { return static_cast<float>(x); };
    const OcclusionParameters parameters{.view = view,
                                         .orthographic = orthographic,
                                         .radius = f(radius),
                                         .range = f(settings.range_radii * radius),
                                         .epsilon = f(settings.epsilon_radii * radius),
                                         .bias = f(settings.bias),
                                         .k_initial = settings.samples,
                                         .k_converged = settings.samples_converged,
                                         .table_size = settings.table_size,
                                         .weight_max = f(settings.weight_max),
                                         .c_spatial = f(settings.c_spatial),
                                         .c_rotation = f(settings.c_rotation),
                                         .depth_epsilon = f(settings.depth_epsilon)};
    return {"occlusion", [this, parameters, count](gpu::Commands& commands) {
                std::vector<gpu::Resource> resources{depth, normal, history[1 - newest], history[newest], raw};
                if (count) resources.emplace_back(records);
                commands.dispatch(count ? gather_and_count : gather, resources, tiles_of(extent), bytes_of(parameters));
            }};
}

Pass AmbientOcclusion::Impl::filter_pass(const ViewParameters& view, bool orthographic, glm::ivec2 axis) const {
    const FilterParameters parameters{.view = view,
                                      .axis = axis,
                                      .orthographic = orthographic,
                                      .half_width = settings.half_width,
                                      .sigma_pixels = static_cast<float>(settings.sigma_pixels),
                                      .weight_max = static_cast<float>(settings.weight_max),
                                      .c_adaptive = static_cast<float>(settings.c_adaptive)};
    const bool first = axis.x == 1;
    return {first ? "filter_x" : "filter_y", [this, parameters, first](gpu::Commands& commands) {
                const std::array<gpu::Resource, 4> resources{depth, history[newest], first ? raw : filtered_x,
                                                             first ? filtered_x : filtered};
                commands.dispatch(filter, resources, tiles_of(extent), bytes_of(parameters));
            }};
}

std::vector<Pass> AmbientOcclusion::Impl::passes(const scene::GBuffer& gbuffer, bool count) const {
    const ViewParameters view{gbuffer.camera.p00_p11(), {extent.width, extent.height}};
    const bool orthographic = gbuffer.camera.orthographic();
    std::vector<Pass> all;
    if (gbuffer.normal.empty()) all.push_back(normals_pass(view, orthographic));
    all.push_back(gather_pass(view, orthographic, count));
    if (settings.filter) {
        all.push_back(filter_pass(view, orthographic, {1, 0}));
        all.push_back(filter_pass(view, orthographic, {0, 1}));
    }
    return all;
}

AmbientOcclusion::AmbientOcclusion(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent,
                                   const Method& method, const Settings& settings, double radius) {
    check(settings, radius);
    impl_ = std::make_unique<Impl>(device, passes, extent, method, settings, radius);
}

AmbientOcclusion::~AmbientOcclusion() = default;
AmbientOcclusion::AmbientOcclusion(AmbientOcclusion&&) noexcept = default;
AmbientOcclusion& AmbientOcclusion::operator=(AmbientOcclusion&&) noexcept = default;

Frame AmbientOcclusion::run(const scene::GBuffer& gbuffer, History history, int repeats) {
    Impl& effect = *impl_;
    require(gbuffer.extent == effect.extent, "ambient occlusion: the G-buffer has another size than the effect");
    if (history == History::restart || !effect.has_history) {
    }
    effect.upload(gbuffer);
    Frame frame;
    return frame;
}

}  // namespace gloam::effect
