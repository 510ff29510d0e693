// SPDX-License-Identifier: MIT
#include "effect/further_views.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>
#include <utility>

#include "effect/internal/frame_images.hpp"
#include "effect/internal/passes.hpp"
#include "effect/internal/steps.hpp"
#include "effect/methods.hpp"

namespace gloam::effect {
namespace {

using enum gpu::BindingKind;

glm::ivec2 size_of(const scene::GBuffer& view) {
    return {static_cast<int>(view.extent.width), static_cast<int>(view.extent.height)};
}

FurtherViewParameters parameters_of(const scene::GBuffer& view, const scene::GBuffer& other,
                                    const Settings& settings) {
    const glm::dmat4 other_from_this =
        glm::dmat4(other.camera.view) * glm::inverse(glm::dmat4(view.camera.view));
    return {.other_from_this = glm::mat4(other_from_this),
            .p00_p11 = view.camera.p00_p11(),
            .other_p00_p11 = other.camera.p00_p11(),
            .size = size_of(view),
            .other_size = size_of(other),
            .radius = settings.radius,
            .bias = settings.bias,
            .bias_depth = settings.bias_depth,
            .remap_a = settings.remap_a,
            .remap_b = settings.remap_b,
            .remap_c = settings.remap_c};
}

void require(const scene::GBuffer& view) {
    if (view.border.width == 0 && view.border.height == 0) return;
    throw std::invalid_argument(fmt::format("further views: a guard band of {} x {} pixels, expected none",
                                            view.border.width, view.border.height));
}

void require(const scene::GBuffer& view, const std::vector<float>& occlusion, const Settings& settings) {
    validate(settings);
    require(view);
    if (method_named(settings.method).prepare != nullptr) {
        throw std::invalid_argument(fmt::format(
            "further views: method {} has preparation passes, expected one without", settings.method));
    }
    if (occlusion.size() == view.depth.size()) return;
    throw std::invalid_argument(
        fmt::format("further views: {} occlusions, expected {}", occlusion.size(), view.depth.size()));
}

}  // namespace

struct FurtherViews::Impl {
    Impl(const gpu::Device& the_device, const scene::PassLibrary& passes)
        : device(&the_device),
          library(passes),
          normals(normals_from_depth(the_device, passes)),
          method(the_device, sizeof(MethodValues)) {}

    const gpu::Device* device;
    scene::PassLibrary library;
    gpu::ComputePipeline normals;
    gpu::Buffer method;
    PassWatcher watcher;                                                 // empty: none
    std::map<std::pair<Program, bool>, gpu::ComputePipeline> pipelines;  // by both cameras

    [[nodiscard]] const gpu::ComputePipeline& pipeline(const Program& program, bool other_orthographic) {
        const std::pair key(program, other_orthographic);
        const auto known = pipelines.find(key);
        if (known != pipelines.end()) return known->second;
        return pipelines
            .emplace(key, pipeline_of(*device, library, further_view_source(program, other_orthographic),
                                      {sampled_image, sampled_image, sampled_image, sampled_image,
                                       storage_image, storage_buffer},
                                      sizeof(FurtherViewParameters)))
            .first->second;
    }

    // Uploads a view; reconstructs missing normals.
    [[nodiscard]] ViewImages taken(const scene::GBuffer& view) {
        ViewImages images(*device, view.extent);
        images.take_linear(*device, view);
        if (!view.normal.empty()) return images;
        const NormalParameters parameters = normal_parameters({view.camera, view.extent, view.border});
        const Step step{"normals_from_depth", &normals, {images.depth, images.normal}, bytes_of(parameters)};
        (void)run(*device, std::span(&step, 1), groups_for(view.extent), 1, {}, watcher);
        return images;
    }
};

FurtherViews::FurtherViews(const gpu::Device& device, const scene::PassLibrary& passes)
    : impl_(std::make_unique<Impl>(device, passes)) {}
FurtherViews::~FurtherViews() = default;
FurtherViews::FurtherViews(FurtherViews&&) noexcept = default;
FurtherViews& FurtherViews::operator=(FurtherViews&&) noexcept = default;

void FurtherViews::watch(PassWatcher watcher) {
    impl_->watcher = std::move(watcher);
}

std::vector<float> FurtherViews::raised(const scene::GBuffer& view, const std::vector<float>& occlusion,
                                        std::span<const scene::GBuffer> others, const Settings& settings) {
    require(view, occlusion, settings);
    for (const scene::GBuffer& other : others) require(other);
    Program program = program_for(settings);
    program.orthographic = view.camera.orthographic();
    impl_->method.as<MethodValues>()[0] = settings.own;
    gpu::Image result(*impl_->device, view.extent, gpu::Format::r32f);
    result.upload(occlusion);
    const ViewImages images = impl_->taken(view);
    for (const scene::GBuffer& other : others) {
        const ViewImages there = impl_->taken(other);
        const FurtherViewParameters parameters = parameters_of(view, other, settings);
        const Step step{"further_view",
                        &impl_->pipeline(program, other.camera.orthographic()),
                        {images.depth, images.normal, there.depth, there.normal, result, impl_->method},
                        bytes_of(parameters)};
        (void)run(*impl_->device, std::span(&step, 1), groups_for(view.extent), 1, {}, impl_->watcher);
    }
    return result.download();
}

}  // namespace gloam::effect
