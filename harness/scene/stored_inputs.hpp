// SPDX-License-Identifier: MIT
#pragma once

#include "scene/gbuffer.hpp"

namespace gloam::scene {

// Depth and normals of a view as an engine with this encoding stores them.
[[nodiscard]] StoredInputs stored_inputs(const GBuffer& view, const Encoding& encoding);

}  // namespace gloam::scene
