// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "stress/run.hpp"

namespace gloam::stress {

constexpr const char* poison_name = "poison";

// Depth and normals that go into the passes of a method. What it returns keeps the passes that methods share,
// so that they are compiled once.
[[nodiscard]] std::function<Rows(const effect::MethodInfo&)> poisoned_passes_of(const Context& context);

// The rows of poisoned_passes_of() for all methods of the context.
[[nodiscard]] Rows poisoned_passes(const Context& context);

// Fetches of methods: none may be outside, whatever the images hold.
[[nodiscard]] Rows poisoned_gathers(const Context& context);

// Fetches of the filter and of normals from depth: none may be outside, either.
[[nodiscard]] Rows poisoned_filters(const Context& context);

// History texels and contributions.
[[nodiscard]] Rows poisoned_history(const Context& context);

// NaN, infinities, negative, subnormal and huge values in depth, normals, history and contributions, one
// texel at a time and everywhere. Occlusion stays in [0, 1]; pixels beyond the footprint stay as they were;
// a poisoned history counts as none. Nothing is fetched outside an image. All the same without
// robustBufferAccess.
[[nodiscard]] Rows poison(const Context& context);

}  // namespace gloam::stress
