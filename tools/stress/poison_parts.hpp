// SPDX-License-Identifier: MIT
#pragma once

#include "stress/run.hpp"

// The parts of poison().
namespace gloam::stress {

constexpr const char* poison_name = "poison";

// Depth and normals that go into the passes.
[[nodiscard]] Rows poisoned_passes(const Context& context);

// Fetches of functions that read images: none may be outside, whatever the images hold.
[[nodiscard]] Rows poisoned_fetches(const Context& context);

// History texels and contributions.
[[nodiscard]] Rows poisoned_history(const Context& context);

}  // namespace gloam::stress
