// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "scene/gbuffer.hpp"

namespace gloam::scene {

// One sentence on how the buffers of a frame contradict each other, or what was said of them; empty where
// they do not. Each kind is a habit of engines that gives a wrong picture, often one without occlusion:
// values outside [0, 1] in a depth buffer; surfaces on the near plane (Z is reversed in one of projection and
// buffer); depths outside of the projection's planes, or those of a depth buffer read as eye-linear; normals
// that are 0, have another length than 1, face away from the eye, or disagree with the depth (another space
// or encoding). A kind is reported where most of the surface shows it, so single pixels may be wrong; a frame
// of fewer than 64 pixels shows too little. view: as read_gbuffer() returns it. as_stored: the same depth and
// normals before they were converted.
[[nodiscard]] std::string contradiction_of(const GBuffer& view, const StoredInputs& as_stored);

// One sentence on why a radius (world units, > 0) gives no occlusion in a view: it is below a pixel at the
// nearest surface, or more than a thousand times the distance of the farthest one. Empty: it fits, or there
// is no surface.
[[nodiscard]] std::string radius_out_of_proportion(const GBuffer& view, double radius);

}  // namespace gloam::scene
