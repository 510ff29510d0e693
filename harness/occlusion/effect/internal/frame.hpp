// SPDX-License-Identifier: MIT
#pragma once

#include "effect/internal/passes.hpp"
#include "effect/plan.hpp"

// The one description of a frame: a table of its passes, and what they read and write.
namespace gloam::effect {

// A plan without passes: the images and buffers of all frames with these settings and views of this size.
[[nodiscard]] Plan planned_resources(const Moment& moment);

// The passes of one frame, in their order: pass_table() evaluated. resources: those that exist; a pass gets
// nothing_image or nothing_buffer in the place of others. The table names what a resource is to the frame:
// `depth`, for example, is the depth that the passes read, and `history` the one that the samples enter. Both
// sets of parameters are those of this frame.
[[nodiscard]] std::vector<PlannedPass> planned_passes(const Moment& moment, const Plan& resources);

}  // namespace gloam::effect
