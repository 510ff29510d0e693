// SPDX-License-Identifier: MIT
#pragma once

#include "scene/scene.hpp"

namespace gloam::scene {

[[nodiscard]] Scene make_columns();

}  // namespace gloam::scene
