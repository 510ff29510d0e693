// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

namespace gloam::scene {

// Weight of a blocker by its distance.
enum class Falloff {
    linear,     // 1 - d / R
    quadratic,  // 1 - d^2 / R^2
    step,       // 1 up to R
};

// The weight in [0, 1] of a blocker at `distance` (>= 0) for a radius > 0 (the same unit); 0 beyond the
// radius.
[[nodiscard]] double falloff_weight(Falloff falloff, double distance, double radius);

// "linear", "quadratic", "step", and back.
[[nodiscard]] const char* name_of(Falloff falloff);
[[nodiscard]] std::optional<Falloff> falloff_named(std::string_view name);

}  // namespace gloam::scene
