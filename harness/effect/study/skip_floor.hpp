// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

namespace gloam::effect {

// A bare floor that fills the view of a walking camera.
[[nodiscard]] scene::Scene skip_floor();

}  // namespace gloam::effect
