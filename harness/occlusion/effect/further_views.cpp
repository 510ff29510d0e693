// SPDX-License-Identifier: MIT
#include "effect/further_views.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "effect/internal/executor.hpp"
#include "effect/internal/passes.hpp"
#include "effect/methods.hpp"

namespace gloam::effect {
namespace {

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
    Impl(const gpu::Device& device, const scene::PassLibrary& passes)
        : executor(device, passes), resources(device) {}

    Executor executor;
    Resources resources;  // of the view, and with the prefix other_ of a further view
    PassWatcher watcher;  // empty: none
};

FurtherViews::FurtherViews(const gpu::Device& device, const scene::PassLibrary& passes)
    : impl_(base::make_hidden<Impl>(device, passes)) {}

void FurtherViews::watch(PassWatcher watcher) {
    impl_->watcher = std::move(watcher);
}

std::vector<float> FurtherViews::raised(const scene::GBuffer& view, const std::vector<float>& occlusion,
                                        std::span<const scene::GBuffer> others, const Settings& settings) {
    require(view, occlusion, settings);
    for (const scene::GBuffer& other : others) require(other);
    Resources& resources = impl_->resources;
    resources.buffer("method", sizeof(MethodValues)).as<MethodValues>()[0] = settings.own;
    gpu::Image& result = resources.image("raised", view.extent, gpu::Format::r32f);
    result.upload(occlusion);
    take_linear(view, resources, impl_->executor, impl_->watcher);
    for (const scene::GBuffer& other : others) {
        take_linear(other, resources, impl_->executor, impl_->watcher, "other_");
        const PlannedPass pass = single_pass(
            "further_view",
            further_view_source(settings, view.camera.orthographic(), other.camera.orthographic()),
            {"depth", "normal", "other_depth", "other_normal", "raised", "method"},
            parameters_of(view, other, settings), groups_for(view.extent));
        impl_->executor.run(std::span(&pass, 1), resources, impl_->watcher);
    }
    return result.download();
}

}  // namespace gloam::effect
