// SPDX-License-Identifier: MIT
#include "effect/internal/passes.hpp"

namespace gloam::effect {
namespace {

using enum gpu::BindingKind;

glm::ivec2 size_of(gpu::Extent extent) {
    return {static_cast<int>(extent.width), static_cast<int>(extent.height)};
}

std::uint32_t flag(bool value) {
    return value ? 1U : 0U;
}

}  // namespace

NormalParameters normal_parameters(const View& view) {
    return {view.camera.p00_p11(), size_of(view.extent), flag(view.camera.orthographic())};
}

OcclusionParameters occlusion_parameters(const View& view, const Settings& settings) {
    return {.p00_p11 = view.camera.p00_p11(),
            .size = size_of(view.extent),
            .radius = settings.radius,
            .bias = settings.bias,
            .range = settings.range,
            .epsilon = settings.epsilon,
            .samples = settings.samples,
            .table_size = settings.table_size,
            .weight_max = settings.weight_max,
            .c_rot = settings.c_rot,
            .least_radius = settings.least_radius,
            .orthographic = flag(view.camera.orthographic()),
            .skip_background = flag(settings.skip_background)};
}

FilterParameters filter_parameters(const View& view, const Settings& settings, glm::ivec2 axis) {
    return {.p00_p11 = view.camera.p00_p11(),
            .size = size_of(view.extent),
            .axis = axis,
            .orthographic = flag(view.camera.orthographic()),
            .half_width = settings.filter_half_width,
            .c_adaptive = settings.c_adaptive,
            .weight_max = settings.weight_max,
            .sigma_pixels = 0.25F * static_cast<float>(2 * settings.filter_half_width + 1)};
}

gpu::ComputePipeline normals_from_depth(const gpu::Device& device, const scene::PassLibrary& library) {
    const shader::Spirv spirv = library.compile("normals_from_depth.comp");
    return {device,
            {.spirv = spirv,
             .bindings = {storage_image, storage_image},
             .push_constant_bytes = sizeof(NormalParameters)}};
}

gpu::ComputePipeline ambient_occlusion(const gpu::Device& device, const scene::PassLibrary& library,
                                       Method method) {
    const shader::Spirv spirv = library.compile("ambient_occlusion.comp");
    return {device,
            {.spirv = spirv,
             .bindings = {storage_image, storage_image, storage_image, storage_image, storage_buffer},
             .push_constant_bytes = sizeof(OcclusionParameters),
             .constants = {{.id = 0, .bits = flag(method == Method::disc)}, {.id = 1, .bits = 1}}}};
}

gpu::ComputePipeline convergence_filter(const gpu::Device& device, const scene::PassLibrary& library) {
    const shader::Spirv spirv = library.compile("convergence_filter.comp");
    return {device,
            {.spirv = spirv,
             .bindings = {storage_image, storage_image, storage_image},
             .push_constant_bytes = sizeof(FilterParameters)}};
}

std::array<std::uint32_t, 3> groups_for(gpu::Extent extent) {
    const auto groups = [](std::uint32_t side) { return (side + tile_side - 1) / tile_side; };
    return {groups(extent.width), groups(extent.height), 1};
}

}  // namespace gloam::effect
