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
inline scene::GBuffer step(float left, float right, double height = 8.0) {
    return view_of({48, 32}, {.projection = scene::Projection::orthographic, .view_height = height},
                   [=](glm::dvec2 at) { return double{at.x < 0.0 ? left : right}; });
}

// The step hides the left half of the hemisphere from the points beside it; it is higher than the radius.
inline constexpr std::size_t beside = 16 * 48 + 24;
inline constexpr float high = 1.5F;
inline constexpr double close = 0.5;  // view: a pixel's centre is a 128th from the step

}  // namespace gloam::effect
