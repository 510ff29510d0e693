// SPDX-License-Identifier: MIT
#include "effect/internal/constants.hpp"

#include "effect/internal/passes.hpp"

namespace gloam::effect {

NormalParameters normal_parameters(const View& view) {
    return {view.camera.p00_p11(), vector_of_size(view.extent), flag(view.camera.orthographic())};
}

InputParameters input_parameters(const View& view) {
    return {.view_from_world = glm::mat3x4(glm::mat3(view.camera.view)),
            .p22_p32 = {view.camera.proj_vk[2][2], view.camera.proj_vk[3][2]},
            .size = vector_of_size(view.extent)};
}

OcclusionParameters occlusion_parameters(const View& view, const Settings& settings) {
    return {.p00_p11 = view.camera.p00_p11(),
            .size = vector_of_size(view.extent),
            .border = vector_of_size(view.border.each_side()),
            .radius = settings.radius,
            .bias = settings.bias,
            .c_spatial = settings.c_spatial,
            .weight_max = settings.weight_max,
            .c_rot = settings.c_rot,
            .least_radius = settings.least_radius,
            .shade_border = flag(settings.guard_history),
            .invalidation = static_cast<std::uint32_t>(settings.invalidation),
            .change_tolerance = settings.change_tolerance,
            .weight_small = settings.weight_small,
            .confidence_factor = settings.confidence_factor,
            .samples_distance = settings.samples_distance,
            .samples_radius = settings.samples_radius,
            .samples_least = settings.samples_least,
            .radius_cap = settings.radius_cap,
            .smoothing = settings.smoothing,
            .bias_depth = settings.bias_depth};
}

MotionParameters motion_parameters(const View& view, const View& before) {
    return {.previous_from_current = view.camera.previous_from_current.value_or(glm::mat4(1.0F)),
            .p00_p11 = view.camera.p00_p11(),
            .previous_p00_p11 = before.camera.p00_p11(),
            .size = vector_of_size(view.extent),
            .motion_unit = {1.0F, 1.0F}};
}

DirectionalParameters directional_parameters(const View& view, const Settings& settings) {
    const glm::mat3 world_from_view = glm::transpose(glm::mat3(view.camera.view));
    return {.p00_p11 = view.camera.p00_p11(),
            .size = vector_of_size(view.extent),
            .radius = settings.radius,
            .bias = settings.bias,
            .samples = settings.samples,
            .orthographic = flag(view.camera.orthographic()),
            .world_from_view = glm::mat3x4(world_from_view)};
}

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
            .orthographic = flag(view.camera.orthographic()),
            .shade_border = all.shade_border,
            .samples_distance = all.samples_distance,
            .samples_radius = all.samples_radius,
            .samples_least = all.samples_least,
            .radius_cap = all.radius_cap,
            .bias_depth = all.bias_depth,
            .level = level};
}

ReprojectionParameters reprojection_parameters(const Moment& moment) {
    return {.previous_from_current = moment.view.camera.previous_from_current.value_or(glm::mat4(1.0F)),
            .p00_p11 = moment.view.camera.p00_p11(),
            .previous_p00_p11 = moment.before.camera.p00_p11(),
            .size = vector_of_size(moment.view.extent),
            .tolerance = moment.settings.depth_tolerance};
}

FilterParameters filter_parameters(const View& view, const Settings& settings) {
    return {.p00_p11 = view.camera.p00_p11(),
            .size = vector_of_size(view.extent),
            .sigma_pixels = settings.filter_sigma * static_cast<float>(2 * settings.filter_half_width + 1),
            .depth_scale = settings.filter_depth,
            .c_adaptive = settings.c_adaptive,
            .weight_max = settings.weight_max,
            .cap = settings.filter_cap};
}

}  // namespace gloam::effect
