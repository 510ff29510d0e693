// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <utility>

#include "check/kernel.hpp"
#include "effect/method_functions.hpp"
#include "effect/preparation.hpp"

namespace gloam::stress {

// GloamCamera of the shader library and GatherKernel of effect::write_method_functions(), member by member.
struct Camera {
    glm::vec2 p00_p11;
    glm::ivec2 size;
    bool orthographic;
};
struct GatherKernel {
    float radius;
    float bias;
    float angle;
    unsigned first;
    unsigned count;
};

struct GatherMethod {
    float range;
    float epsilon;
    float intensity = 1.0F;
    float thickness = 1.0F;
    float angle_bias = 0.0F;
    float mip_distance = 0.0F;
    unsigned steps = 1;
    float disagreement = 0.05F;
    float feature_thickness = 1.0F;
};

// (position, normal, camera, kernel, method) to (sum, count); reads depths by gloam_fetch_depth.
using Gather = check::Kernel<glm::vec2(glm::vec3, glm::vec3, Camera, GatherKernel, GatherMethod)>;

[[nodiscard]] constexpr GatherMethod method_of_length(float length) {
    return {.range = length, .epsilon = length};
}

// Of the lab's folder of effect::write_method_functions().
[[nodiscard]] inline std::string gather_file(const effect::MethodInfo& method) {
    return method.name + ".glsl";
}

// What a method prepares for an image of that size; one of mssao for `resolutions`.
[[nodiscard]] inline std::optional<effect::Preparation> gather_preparation(const effect::MethodInfo& method,
                                                                           glm::ivec2 size,
                                                                           unsigned resolutions) {
    effect::Settings settings;
    settings.method = method.name;
    settings.own.steps = resolutions;
    return effect::preparation_of(settings,
                                  {static_cast<std::uint32_t>(size.x), static_cast<std::uint32_t>(size.y)});
}

// The images that a method reads: depths, and for one that prepares something its image, every texel alike.
[[nodiscard]] inline check::ImageSet gather_images(check::Image depths,
                                                   const std::optional<effect::Preparation>& preparation,
                                                   float prepared) {
    // Normals as bad as the depths.
    check::Image normals = check::make_image<glm::vec3>(
        depths.size, [&](glm::ivec2 at) { return glm::vec3(0, 0, depths.at<float>(at)); });
    check::ImageSet images{{"gloam_fetch_depth", std::move(depths)},
                           {"gloam_fetch_normal", std::move(normals)}};
    if (!preparation) return images;
    const glm::ivec2 size(preparation->image.width, preparation->image.height);
    images.emplace("gloam_fetch_prepared",
                   check::make_image<glm::vec4>(size, [=](glm::ivec2) { return glm::vec4(prepared); }));
    return images;
}

}  // namespace gloam::stress
