// SPDX-License-Identifier: MIT
#include "effect/internal/prepared_image.hpp"

#include <utility>

namespace gloam::effect {

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

PreparationProgram preparation_program_for(const Settings& settings) {
    return {.precision = bound_precision(settings),
            .layers = settings.layers,
            .reject_taps = settings.reject_taps,
            .keeps_history = settings.history,
            .samples = settings.samples,
            .samples_converged = settings.samples_converged,
            .steps = settings.own.steps};
}

PassSource preparation_source(const std::string& file, const PreparationProgram& program,
                              gpu::Format format) {
    return {.file = "preparation/" + file,
            .defines = defines_for(program.precision, format),
            .constants = {{.id = 0, .bits = program.layers},
                          {.id = 1, .bits = program.reject_taps ? 1U : 0U},
                          {.id = 2, .bits = program.keeps_history ? 1U : 0U},
                          {.id = 3, .bits = program.samples},
                          {.id = 4, .bits = program.samples_converged},
                          {.id = 5, .bits = program.steps}}};
}

PreparedImage::PreparedImage(const gpu::Device& device, const scene::PassLibrary& library)
    : device_(&device), library_(library) {}

void PreparedImage::take(const View& view, const Settings& settings) {
    program_ = preparation_program_for(settings);
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
    const std::pair key(file, program_);
    const auto known = pipelines_.find(key);
    if (known != pipelines_.end()) return known->second;
    using enum gpu::BindingKind;
    return pipelines_
        .emplace(key,
                 pipeline_of(*device_, library_, preparation_source(file, program_, preparation_->format),
                             {sampled_image, sampled_image, sampled_image, storage_image, storage_buffer,
                              sampled_image, sampled_image},
                             sizeof(PreparationParameters)))
        .first->second;
}

void PreparedImage::append_steps(const Sources& sources, std::vector<Step>& steps) {
    if (!preparation_) return;
    for (std::size_t i = 0; i < preparation_->passes.size(); ++i) {
        const PreparationPass& pass = preparation_->passes[i];
        steps.push_back({.name = pass.name,
                         .pipeline = &pipeline(pass.file),
                         .resources = {sources.depth, sources.normal, sources.history, *image_,
                                       sources.method, sources.layers, *image_},
                         .parameters = bytes_of(constants_[i]),
                         .groups = groups_for(pass.invocations)});
    }
}

}  // namespace gloam::effect
