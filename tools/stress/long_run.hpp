// SPDX-License-Identifier: MIT
#pragma once

#include "stress/run.hpp"

namespace gloam::stress {

// The history carried over Context::frames frames on the device, through gloam_history_unpack, gloam_blend,
// gloam_next_index and gloam_history_pack as a pass does it, in float32 and stored as float16, for constant,
// alternating, jumping, noisy and rare contributions. Compared with the mean in double:
//   farthest from the exact mean, and its average over time (bias); at most E (w_max + k) / k, where E is the
//   error of one frame: that of gloam_blend, in float16 also that of one store;
//   weight and index; exact.
// Besides: the sequence of points where its index passes 2^24 and 2^32.
[[nodiscard]] Rows long_run(const Context& context);

}  // namespace gloam::stress
