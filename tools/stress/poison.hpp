// SPDX-License-Identifier: MIT
#pragma once

#include "stress/run.hpp"

namespace gloam::stress {

// NaN, infinities, negative, subnormal and huge values in depth, normals, history and contributions, one
// texel at a time and everywhere. Occlusion stays in [0, 1]; pixels beyond the footprint stay as they were;
// a poisoned history counts as none. Nothing is fetched outside an image. All the same without
// robustBufferAccess.
[[nodiscard]] Rows poison(const Context& context);

}  // namespace gloam::stress
