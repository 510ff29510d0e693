// SPDX-License-Identifier: MIT
#pragma once

#include "stress/run.hpp"

namespace gloam::stress {

// Scene and camera moved together, as far as 1e8 units. What is centred on the camera (positions and eye
// difference formed in double by the host) must not change in a single bit: matrices, previous positions,
// previous texture coordinates, and the picture of a whole scene. The same in world coordinates: how many
// pixels it is off at which distance.
[[nodiscard]] Rows far_away(const Context& context);

}  // namespace gloam::stress
