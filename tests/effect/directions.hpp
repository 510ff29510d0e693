// SPDX-License-Identifier: MIT
#pragma once

#include "effect/directional.hpp"
#include "on_device.hpp"

// Bent normals and light of a step whose results are known.
namespace gloam::effect {

class Directions : public OnDevice<testing::Test> {
  protected:
    Directional directional_{device_, passes_};
};

inline Settings many(float radius = 1.0F) {
    Settings settings = with_radius({}, radius);
    settings.samples = 1024;
    return settings;
}

// A wall parallel to the image, orthographic. Its left part may stand nearer.
inline scene::GBuffer step(float left, float right, double view_height = 8.0) {
    constexpr gpu::Extent extent{48, 32};
    scene::GBuffer view{
        .extent = extent, .depth = {}, .normal = std::vector(std::size_t{48} * 32, glm::vec3(0, 0, 1))};
    for (std::size_t i = 0; i < view.normal.size(); ++i) view.depth.push_back(i % 48 < 24 ? left : right);
    view.camera =
        scene::make_frame({.projection = scene::Projection::orthographic, .view_height = view_height}, 1.5);
    return view;
}

// The step hides the left half of the hemisphere from the points beside it; it is higher than the radius.
inline constexpr std::size_t beside = 16 * 48 + 24;
inline constexpr float high = 1.5F;
inline constexpr double close = 0.5;  // view: a pixel's centre is a 128th from the step

}  // namespace gloam::effect
