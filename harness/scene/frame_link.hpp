// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene/gbuffer.hpp"

namespace gloam::scene {

// Why a history cannot be followed from one view to the next of a sequence: "the size has changed", "there is
// no prev_view", "prev_view is not the view before". Empty: it can.
[[nodiscard]] std::string cut_between(const GBuffer& previous, const GBuffer& view);

// Completes a view of a sequence read from files, to what rasterize() gives: previous_from_current from the
// matrices where it is missing, and, where there are motion vectors, previous_position from them. A point's
// depth then is previous_depth where that was given, else what the cameras make of it: right for what stands
// still, and for objects as far as they do not move towards the eye. Where motion is not valid and leads into
// the previous image, the position is 0: no history. Without motion vectors the cameras alone tell, for a
// scene that stands still. For views that cut_between() lets pass; what is there already stays.
void link(GBuffer& view, const GBuffer& previous);

}  // namespace gloam::scene
