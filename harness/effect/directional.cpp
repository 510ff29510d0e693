// SPDX-License-Identifier: MIT
#include "effect/directional.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include "effect/internal/frame_images.hpp"
#include "effect/internal/passes.hpp"
#include "effect/internal/require_view.hpp"
#include "effect/internal/steps.hpp"
#include "effect/internal/texels.hpp"
#include "scene/guard_band.hpp"

namespace gloam::effect {

// What a pass is compiled for.
struct DirectionalProgram {
    std::string pass;
    std::uint32_t layers = 1;
    std::uint32_t interleave = 0;  // 0: the pass does not use it
    std::size_t reads = 0;         // images that it reads besides those that all passes read

    [[nodiscard]] auto operator<=>(const DirectionalProgram&) const = default;
};

namespace {

using enum gpu::BindingKind;
using enum gpu::Format;

constexpr int most_interleave = 8;

DirectionalParameters parameters_of(const scene::GBuffer& view, const Settings& settings) {
    const glm::mat3 world_from_view = glm::transpose(glm::mat3(view.camera.view));
    return {.p00_p11 = view.camera.p00_p11(),
            .size = {static_cast<int>(view.extent.width), static_cast<int>(view.extent.height)},
            .radius = settings.radius,
            .bias = settings.bias,
            .samples = settings.samples,
            .orthographic = view.camera.orthographic() ? 1U : 0U,
            .world_from_view = glm::mat3x4(world_from_view)};
}

gpu::ComputePipeline make_pipeline(const gpu::Device& device, const scene::PassLibrary& library,
                                   const DirectionalProgram& program) {
    std::vector<gpu::BindingKind> bindings{sampled_image, sampled_image, sampled_image, storage_buffer,
                                           storage_image};
    bindings.insert(bindings.end(), program.reads, sampled_image);
    PassSource source{.file = program.pass + ".comp", .constants = {{.id = 0, .bits = program.layers}}};
    if (program.interleave > 0) source.constants.push_back({.id = 1, .bits = program.interleave});
    return pipeline_of(device, library, source, std::move(bindings), sizeof(DirectionalParameters));
}

void require(const scene::GBuffer& view, const Settings& settings) {
    validate(settings);
    if (!view.color.empty() && view.color.size() != view.depth.size()) {
        throw std::invalid_argument(
            fmt::format("colours: {} pixels, expected {}", view.color.size(), view.depth.size()));
    }
    require_layers(view, settings);
}

}  // namespace

struct Directional::Impl {
    Impl(const gpu::Device& the_device, const scene::PassLibrary& passes)
        : device(&the_device),
          library(passes),
          normals(normals_from_depth(the_device, passes)),
          nothing(the_device, {1, 1}, rgba32f),
          method(the_device, sizeof(MethodValues)) {}

    const gpu::Device* device;
    scene::PassLibrary library;
    gpu::ComputePipeline normals;
    std::map<DirectionalProgram, gpu::ComputePipeline> pipelines;
    gpu::Image nothing;
    gpu::Buffer method;
    PassWatcher watcher;  // empty: none

    [[nodiscard]] const gpu::ComputePipeline& pipeline(const DirectionalProgram& program) {
        const auto found = pipelines.find(program);
        if (found != pipelines.end()) return found->second;
        return pipelines.emplace(program, make_pipeline(*device, library, program)).first->second;
    }

    // Uploads a view; reconstructs missing normals.
    [[nodiscard]] ViewImages taken(const scene::GBuffer& view, const Settings& settings) {
        require(view, settings);
        ViewImages images(*device, view.extent);
        images.take_linear(*device, view);
        method.as<MethodValues>()[0] = settings.own;
        if (view.normal.empty()) {
            const NormalParameters parameters = normal_parameters({view.camera, view.extent, view.border});
            const Step step{
                "normals_from_depth", &normals, {images.depth, images.normal}, bytes_of(parameters)};
            (void)run(*device, std::span(&step, 1), groups_for(view.extent), 1, {}, watcher);
        }
        return images;
    }

    // Runs a pass that writes `out`. `read`: the images at its further bindings.
    void shade(const std::string& pass, const ViewImages& images, const gpu::Image& out,
               std::vector<gpu::Resource> read, const scene::GBuffer& view, const Settings& settings,
               std::uint32_t interleave = 0) {
        const DirectionalParameters parameters = parameters_of(view, settings);
        std::vector<gpu::Resource> resources{images.depth, images.normal,
                                             images.layers ? *images.layers : nothing, method, out};
        resources.insert(resources.end(), read.begin(), read.end());
        const DirectionalProgram program{pass, settings.layers, interleave, read.size()};
        const Step step{pass, &pipeline(program), std::move(resources), bytes_of(parameters)};
        (void)run(*device, std::span(&step, 1), groups_for(view.extent), 1, {}, watcher);
    }
};

Directional::Directional(const gpu::Device& device, const scene::PassLibrary& passes)
    : impl_(std::make_unique<Impl>(device, passes)) {}
Directional::~Directional() = default;
Directional::Directional(Directional&&) noexcept = default;
Directional& Directional::operator=(Directional&&) noexcept = default;

void Directional::watch(PassWatcher watcher) {
    impl_->watcher = std::move(watcher);
}

BentNormals Directional::bent_normals(const scene::GBuffer& view, const Settings& settings,
                                      const BentOptions& options) {
    if (options.interleave < 1 || options.interleave > most_interleave) {
        throw std::invalid_argument(
            fmt::format("interleave {}: expected 1 to {}", options.interleave, most_interleave));
    }
    const auto interleave = static_cast<std::uint32_t>(options.interleave);
    const ViewImages images = impl_->taken(view, settings);
    gpu::Image bent(*impl_->device, view.extent, rgba32f);
    impl_->shade("bent_normals", images, bent, {}, view, settings, interleave);
    if (interleave > 1) {
        gpu::Image gathered(*impl_->device, view.extent, rgba32f);
        impl_->shade("bent_gather", images, gathered, {bent}, view, settings, interleave);
        bent = std::move(gathered);
    }
    const std::vector<float> texels = bent.download();
    return {.extent = scene::frame_of(view),
            .direction = scene::cropped(view, vectors_of(texels)),
            .half_angle = scene::cropped(view, channel(texels, 3))};
}

DirectionalLight Directional::light(const scene::GBuffer& view, const Settings& settings,
                                    const scene::Environment& environment) {
    const ViewImages images = impl_->taken(view, settings);
    const gpu::Device& device = *impl_->device;
    gpu::Image albedo(device, view.extent, rgba32f);
    albedo.upload(view.color.empty() ? std::vector<float>(4 * view.depth.size(), 1.0F)
                                     : texels_of(view.color));
    gpu::Image around(device, environment.extent, rgba32f);
    around.upload(texels_of(environment.radiance));
    const gpu::Image direct(device, view.extent, rgba32f);
    const gpu::Image bounced(device, view.extent, rgba32f);
    impl_->shade("direct_light", images, direct, {albedo, around}, view, settings);
    impl_->shade("bounced_light", images, bounced, {albedo, direct}, view, settings);
    return {.extent = scene::frame_of(view),
            .direct = scene::cropped(view, vectors_of(direct.download())),
            .bounced = scene::cropped(view, vectors_of(bounced.download()))};
}

}  // namespace gloam::effect
