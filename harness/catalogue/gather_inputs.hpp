// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "check/image.hpp"
#include "check/question.hpp"
#include "check/values.hpp"
#include "reference/geometry_camera.hpp"
#include "reference/occlusion.hpp"

// Inputs of the estimators of a pixel, which read depths through a prototype.
namespace gloam::catalogue {

inline constexpr const char* depth_prototype = "gloam_fetch_depth";

// The depth at a pixel, and those of the layers behind it.
[[nodiscard]] inline auto layers_of(const check::ImageSet& images) {
    return [&images](glm::ivec2 pixel) {
        return glm::dvec4(images.at(depth_prototype).at<double>(pixel),
                          images.at("gloam_fetch_layers").at<glm::dvec3>(pixel));
    };
}

// vec3, drawn as (ndc, depth): see place_before_camera.
[[nodiscard]] check::Values gather_positions();
// GloamKernel of up to 8 samples and 4 layers.
[[nodiscard]] check::Values gather_kernels();
// A length of the scene's size.
[[nodiscard]] check::Values gather_length();

// Whether coordinates and lengths are so small that no product overflows.
[[nodiscard]] bool usual_gather(const glm::vec3& position, const glm::vec3& normal,
                                const reference::GloamCamera& camera, const reference::GloamKernel& kernel);

// Depth images, and three layers behind them: fronts, backs, and pixels without one.
[[nodiscard]] std::vector<check::ImageScenario> gather_scenarios();

}  // namespace gloam::catalogue
