// SPDX-License-Identifier: MIT
#include "effect/directional.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

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
    bool keeps_history = false;    // it includes directional/history.glsl
    std::size_t reads = 0;         // images that it reads besides those that all passes read

    [[nodiscard]] auto operator<=>(const DirectionalProgram&) const = default;
};

// A filter's pass over light along one axis.
struct LightFilterProgram {
    bool along_y = false;
    bool orthographic = false;
    int half_width = 2;

    [[nodiscard]] auto operator<=>(const LightFilterProgram&) const = default;
};

// A frame's light: direct in xyz and samples in w; bounced in xyz and depth in w.
struct LightImages {
    LightImages(const gpu::Device& device, gpu::Extent size)
        : direct(device, size, gpu::Format::rgba32f), bounced(device, size, gpu::Format::rgba32f) {}
    gpu::Image direct;
    gpu::Image bounced;
};

// What light keeps from frame to frame, and what it needs within one.
struct LightFrames {
    LightFrames(const gpu::Device& device, gpu::Extent size)
        : before(device, size), now(device, size), half_filtered(device, size), filtered(device, size) {}
    LightImages before;
    LightImages now;
    LightImages half_filtered;
    LightImages filtered;
    View view;                // of the frame before
    std::uint64_t count = 0;  // frames since the history began
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
    if (program.keeps_history)
        bindings.insert(bindings.end(), {storage_buffer, sampled_image, sampled_image, sampled_image});
    bindings.insert(bindings.end(), program.reads, sampled_image);
    PassSource source{.file = program.pass + ".comp", .constants = {{.id = 0, .bits = program.layers}}};
    if (program.interleave > 0) source.constants.push_back({.id = 1, .bits = program.interleave});
    return pipeline_of(device, library, source, std::move(bindings), sizeof(DirectionalParameters));
}

gpu::ComputePipeline make_filter(const gpu::Device& device, const scene::PassLibrary& library,
                                 const LightFilterProgram& program) {
    const PassSource source{.file = "light_filter.comp",
                            .constants = {{.id = 0, .bits = flag(program.along_y)},
                                          {.id = 1, .bits = flag(program.orthographic)},
                                          {.id = 2, .bits = static_cast<std::uint32_t>(program.half_width)}}};
    return pipeline_of(device, library, source,
                       {sampled_image, sampled_image, sampled_image, storage_image, storage_image},
                       sizeof(FilterParameters));
}

// The albedo of each pixel, in [0, 1].
std::vector<glm::vec3> albedo_of(const scene::GBuffer& view) {
    if (view.color.empty()) return std::vector(view.depth.size(), glm::vec3(1.0F));
    std::vector<glm::vec3> albedo = view.color;
    for (glm::vec3& color : albedo)
        for (int i = 0; i < 3; ++i) color[i] = color[i] > 0.0F ? std::min(color[i], 1.0F) : 0.0F;
    return albedo;
}

// The light of the frame, without the guard band.
std::vector<glm::vec3> sent(const scene::GBuffer& view, const gpu::Image& light,
                            const std::vector<glm::vec3>& albedo) {
    std::vector<glm::vec3> radiance = vectors_of(light.download());
    std::ranges::transform(radiance, albedo, radiance.begin(),
                           [](const glm::vec3& a, const glm::vec3& b) { return a * b; });
    return scene::cropped(view, radiance);
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
          method(the_device, sizeof(MethodValues)),
          history(the_device, sizeof(LightHistory)) {}

    const gpu::Device* device;
    scene::PassLibrary library;
    gpu::ComputePipeline normals;
    std::map<DirectionalProgram, gpu::ComputePipeline> pipelines;
    gpu::Image nothing;
    gpu::Buffer method;
    gpu::Buffer history;  // LightHistory
    std::map<LightFilterProgram, gpu::ComputePipeline> filter_pipelines;
    std::optional<LightFrames> light;
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
               std::uint32_t interleave = 0, bool keeps_history = false) {
        const DirectionalParameters parameters = parameters_of(view, settings);
        std::vector<gpu::Resource> resources{images.depth, images.normal,
                                             images.layers ? *images.layers : nothing, method, out};
        if (keeps_history)
            resources.insert(resources.end(),
                             {history, light->before.direct, light->before.bounced,
                              images.previous_position ? *images.previous_position : nothing});
        resources.insert(resources.end(), read.begin(), read.end());
        const DirectionalProgram program{pass, settings.layers, interleave, keeps_history, read.size()};
        const Step step{pass, &pipeline(program), std::move(resources), bytes_of(parameters)};
        (void)run(*device, std::span(&step, 1), groups_for(view.extent), 1, {}, watcher);
    }

    // Decides what the frame keeps of the one before, and sets LightHistory.
    void follow(const scene::GBuffer& view, const Settings& settings, const ViewImages& images,
                LightFollows follows) {
        const bool fits = light && light->view.extent == view.extent;
        const bool linked = follows == LightFollows::same_view ||
                            (follows == LightFollows::last_view && view.camera.previous_from_current);
        if (!fits) light.emplace(*device, view.extent);
        if (!fits || !linked || !settings.history) light->count = 0;
        const bool same = follows == LightFollows::same_view;
        const scene::CameraFrame& previous = light->count > 0 ? light->view.camera : view.camera;
        history.as<LightHistory>()[0] = {
            .previous_from_current = view.camera.previous_from_current.value_or(glm::mat4(1.0F)),
            .previous_p00_p11 = previous.p00_p11(),
            .kept = light->count == 0 ? 0U
                    : same            ? 1U
                                      : 2U,
            .objects_move = flag(light->count > 0 && !same && images.previous_position.has_value()),
            .previous_orthographic = flag(previous.orthographic()),
            .first_sample = static_cast<std::uint32_t>(light->count * settings.samples % settings.table_size),
            .weight_max = settings.weight_max,
            .depth_tolerance = settings.depth_tolerance,
            .invalidation = static_cast<std::uint32_t>(settings.invalidation),
            .change_tolerance = settings.change_tolerance,
            .weight_small = settings.weight_small,
            .confidence_factor = settings.confidence_factor};
        light->view = {view.camera, view.extent, view.border};
    }

    // Smooths the frame's light, if the settings filter it. Returns what is displayed.
    [[nodiscard]] const LightImages& smoothed(const ViewImages& images, const Settings& settings) {
        if (!filters(settings, light->count)) return light->now;
        const FilterParameters parameters = filter_parameters(light->view, settings);
        const auto along = [&](bool y, const LightImages& from, const LightImages& to) {
            const LightFilterProgram program{y, light->view.camera.orthographic(),
                                             settings.filter_half_width};
            auto found = filter_pipelines.find(program);
            if (found == filter_pipelines.end())
                found = filter_pipelines.emplace(program, make_filter(*device, library, program)).first;
            return Step{"light_filter",
                        &found->second,
                        {images.depth, from.direct, from.bounced, to.direct, to.bounced},
                        bytes_of(parameters)};
        };
        const std::array steps{along(false, light->now, light->half_filtered),
                               along(true, light->half_filtered, light->filtered)};
        (void)run(*device, steps, groups_for(light->view.extent), 1, {}, watcher);
        return light->filtered;
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
                                    const scene::Environment& environment, LightFollows follows) {
    const ViewImages images = impl_->taken(view, settings);
    impl_->follow(view, settings, images, follows);
    const gpu::Device& device = *impl_->device;
    const std::vector<glm::vec3> color = albedo_of(view);
    gpu::Image albedo(device, view.extent, rgba32f);
    albedo.upload(texels_of(color));
    gpu::Image around(device, environment.extent, rgba32f);
    around.upload(texels_of(environment.radiance));
    LightFrames& light = *impl_->light;
    impl_->shade("direct_light", images, light.now.direct, {around}, view, settings, 0, true);
    impl_->shade("bounced_light", images, light.now.bounced, {albedo, light.now.direct}, view, settings, 0,
                 true);
    const LightImages& shown = impl_->smoothed(images, settings);
    DirectionalLight result{.extent = scene::frame_of(view),
                            .direct = sent(view, shown.direct, color),
                            .bounced = sent(view, shown.bounced, color)};
    std::swap(light.before, light.now);
    ++light.count;
    return result;
}

}  // namespace gloam::effect
