// SPDX-License-Identifier: MIT
#include "cli/render_further.hpp"

#include <cmath>
#include <numbers>

#include "report/image.hpp"
#include "scene/rasterize.hpp"

namespace gloam::cli {
namespace {

constexpr double step_degrees = 40.0;

// The eye turned around the target, about the camera's vertical.
scene::Camera turned(scene::Camera camera, double radians) {
    const glm::dvec3 axis = glm::normalize(camera.up);
    const glm::dvec3 v = camera.eye - camera.target;
    const glm::dvec3 around = std::cos(radians) * v + std::sin(radians) * glm::cross(axis, v) +
                              (1.0 - std::cos(radians)) * glm::dot(axis, v) * axis;
    camera.eye = camera.target + around;
    return camera;
}

}  // namespace

std::vector<scene::GBuffer> further_views_of(const gpu::Device& device, const scene::PassLibrary& passes,
                                             const scene::Scene& scene, int frame, gpu::Extent extent,
                                             int count) {
    std::vector<scene::GBuffer> views;
    for (int i = 0; i < count; ++i) {
        const double degrees = step_degrees * (i / 2 + 1) * (i % 2 == 0 ? 1.0 : -1.0);
        scene::Scene seen = scene;
        seen.camera = turned(camera_at(scene, frame), degrees * std::numbers::pi / 180.0);
        seen.camera_path = {};
        views.push_back(scene::rasterize(device, passes, seen, extent, {.frame = frame}));
    }
    return views;
}

void write_further(report::OutputFolder& folder, const std::string& stem, gpu::Extent extent,
                   const std::vector<float>& occlusion) {
    folder.write(stem + "_views.pfm", report::to_pfm(occlusion, extent.width, extent.height, 1));
    folder.write(stem + "_views.png", report::to_visibility_png(occlusion, extent.width, extent.height));
}

}  // namespace gloam::cli
