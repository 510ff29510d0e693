// SPDX-License-Identifier: MIT
#include "effect/internal/prepared_image.hpp"

#include <utility>

namespace gloam::effect {
namespace {

PreparationParameters preparation_parameters(const View& view, const Settings& settings, int level) {
    const OcclusionParameters all = occlusion_parameters(view, settings);
    return {.p00_p11 = all.p00_p11,
            .size = all.size,
            .border = all.border,
            .radius = all.radius,
            .bias = all.bias,
            .c_spatial = all.c_spatial,
            .weight_max = all.weight_max,
            .c_rot = all.c_rot,
            .least_radius = all.least_radius,
            .orthographic = view.camera.orthographic() ? 1U : 0U,
            .shade_border = all.shade_border,
            .samples_distance = all.samples_distance,
            .samples_radius = all.samples_radius,
            .samples_least = all.samples_least,
            .radius_cap = all.radius_cap,
            .bias_depth = all.bias_depth,
            .level = level};
}

gpu::ComputePipeline preparation_pipeline(const gpu::Device& device, const scene::PassLibrary& library,
                                          const std::string& file, const std::vector<std::string>& defines,
                                          std::vector<gpu::SpecializationConstant> constants) {
    using enum gpu::BindingKind;
    const shader::Spirv spirv = library.compile("preparation/" + file, defines);
    return {device,
            {.spirv = spirv,
             .bindings = {storage_image, storage_image, storage_image, storage_image, storage_buffer,
                          storage_image},
             .push_constant_bytes = sizeof(PreparationParameters),
             .constants = std::move(constants)}};
}

}  // namespace

PreparedImage::PreparedImage(const gpu::Device& device, const scene::PassLibrary& library)
    : device_(&device), library_(library) {}

void PreparedImage::take(const View& view, const Settings& settings) {
    compiled_ = {.file = {},
                 .precision = settings.precision,
                 .layers = settings.layers,
                 .reject_taps = settings.reject_taps,
                 .history = settings.history,
                 .samples = settings.samples,
                 .samples_converged = settings.samples_converged,
                 .steps = settings.steps};
    preparation_ = preparation_of(settings, view.extent);
    constants_.clear();
    if (!preparation_) {
        image_.reset();
        return;
    }
    const bool fits =
        image_ && image_->extent() == preparation_->image && image_->format() == preparation_->format;
    if (!fits) {
        image_.emplace(*device_, preparation_->image, preparation_->format);
    }
    for (const PreparationPass& pass : preparation_->passes)
        constants_.push_back(preparation_parameters(view, settings, pass.level));
}

const gpu::ComputePipeline& PreparedImage::pipeline(const std::string& file) {
    compiled_.file = file;
    const auto known = pipelines_.find(compiled_);
    if (known != pipelines_.end()) return known->second;
    const std::vector<std::string> defines = defines_for(compiled_.precision, preparation_->format);
    const std::vector<gpu::SpecializationConstant> constants{
        {.id = 0, .bits = compiled_.layers},
        {.id = 1, .bits = compiled_.reject_taps ? 1U : 0U},
        {.id = 2, .bits = compiled_.history ? 1U : 0U},
        {.id = 3, .bits = compiled_.samples},
        {.id = 4, .bits = compiled_.samples_converged},
        {.id = 5, .bits = compiled_.steps}};
    return pipelines_.emplace(compiled_, preparation_pipeline(*device_, library_, file, defines, constants))
        .first->second;
}

void PreparedImage::append_steps(const Sources& sources, std::vector<Step>& steps) {
    if (!preparation_) return;
    for (std::size_t i = 0; i < preparation_->passes.size(); ++i) {
        const PreparationPass& pass = preparation_->passes[i];
        steps.push_back({.name = pass.name,
                         .pipeline = &pipeline(pass.file),
                         .resources = {sources.depth, sources.normal, sources.history, *image_,
                                       sources.method, sources.layers},
                         .parameters = bytes_of(constants_[i]),
                         .groups = groups_for(pass.invocations)});
    }
}

}  // namespace gloam::effect
