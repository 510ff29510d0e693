// SPDX-License-Identifier: MIT
#include "effect/internal/passes.hpp"

#include <utility>

#include "shader/include.hpp"

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

PassLibrary::PassLibrary(const gpu::Device& device, std::filesystem::path glsl, shader::SpirvCache cache)
    : device_(&device), glsl_(std::move(glsl)), cache_(std::move(cache)) {}

gpu::ComputePipeline PassLibrary::make(const std::string& name, gpu::ComputeProgram program) const {
    const std::filesystem::path file = glsl_ / "passes" / (name + ".comp");
    const shader::Spirv spirv =
        cache_.compile({.name = file.string(), .text = shader::read_text(file)},
                       {.include_roots = {glsl_}, .optimization = shader::Optimization::performance});
    program.spirv = spirv;
    return {*device_, program};
}

gpu::ComputePipeline PassLibrary::normals_from_depth() const {
    return make("normals_from_depth", {.bindings = {storage_image, storage_image},
                                       .push_constant_bytes = sizeof(NormalParameters)});
}

gpu::ComputePipeline PassLibrary::ambient_occlusion(Method method) const {
    return make("ambient_occlusion",
                {.bindings = {storage_image, storage_image, storage_image, storage_image, storage_buffer},
                 .push_constant_bytes = sizeof(OcclusionParameters),
                 .constants = {{.id = 0, .bits = flag(method == Method::disc)}, {.id = 1, .bits = 1}}});
}

gpu::ComputePipeline PassLibrary::convergence_filter() const {
    return make("convergence_filter", {.bindings = {storage_image, storage_image, storage_image},
                                       .push_constant_bytes = sizeof(FilterParameters)});
}

std::array<std::uint32_t, 3> groups_for(gpu::Extent extent) {
    const auto groups = [](std::uint32_t side) { return (side + tile_side - 1) / tile_side; };
    return {groups(extent.width), groups(extent.height), 1};
}

}  // namespace gloam::effect
