// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "effect/errors.hpp"

namespace gloam::effect {

// The remap of a visibility v in [0, 1] (CS-REMAP): v' = (b (v + a))^c, clamped to [0, 1]. A base below 0
// gives 0.
struct Remap {
    double a = 0.0;
    double b = 1.0;
    double c = 1.0;

    [[nodiscard]] double operator()(double visibility) const;
};

// The remap that minimises the root mean square difference of an occlusion image from the truth. It shows how
// accurate a method is apart from constant factors. The result is deterministic, and its error is never
// larger than without a remap. If no truth is known, the result is no remap. Throws std::invalid_argument
// when the sizes disagree.
[[nodiscard]] Remap best_remap(std::span<const float> occlusion, std::span<const float> truth);

// The occlusion image after a remap.
[[nodiscard]] std::vector<float> remapped(std::span<const float> occlusion, const Remap& remap);

}  // namespace gloam::effect
