// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <utility>

#include "check/function.hpp"
#include "effect/method_functions.hpp"
#include "effect/methods.hpp"

namespace gloam::stress {

using effect::GatherCamera;
using effect::GatherKernel;

// Of a method: (sum, count); reads depths by gloam_fetch_depth.
using Gather = check::Function<effect::MethodGather>;

[[nodiscard]] constexpr effect::MethodValues method_of_length(float length) {
    return {.range = length, .epsilon = length, .thickness = 1.0F, .steps = 1, .disagreement = 0.05F};
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
