// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

// The makers of the built-in scenes.
namespace gloam::scene {

[[nodiscard]] Scene make_columns();
[[nodiscard]] Scene make_corner();
[[nodiscard]] Scene make_far();
[[nodiscard]] Scene make_grass();
[[nodiscard]] Scene make_knot();
[[nodiscard]] Scene make_moving();
[[nodiscard]] Scene make_relief();
[[nodiscard]] Scene make_room();
[[nodiscard]] Scene make_sky();

}  // namespace gloam::scene
