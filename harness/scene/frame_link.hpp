// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene/gbuffer.hpp"

namespace gloam::scene {

// The reason why a history cannot be followed from one view to the next: "the size has changed", "there is no
// prev_view", "prev_view is not the view before". Empty: it can.
[[nodiscard]] std::string cut_between(const GBuffer& previous, const GBuffer& view);

// Completes a view that was read from files, as rasterize() would: previous_from_current from the matrices if
// it is missing, and previous_position from the motion vectors if there are any. The earlier depth of a point
// is previous_depth if given. Otherwise it follows from the cameras, which is right for static objects and
// for objects that do not move towards the eye.
// If motion is invalid and leads into the previous image, the position is 0: no history. Without motion
// vectors the cameras alone are used, for a static scene. Existing values are kept. Requires that
// cut_between() returns "".
void link(GBuffer& view, const GBuffer& previous);

}  // namespace gloam::scene
