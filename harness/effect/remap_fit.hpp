// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "effect/errors.hpp"

namespace gloam::effect {

// The remap of a visibility v in [0, 1] (CS-REMAP): v' = (b (v + a))^c, clamped to [0, 1]. 0 for a base
// below 0.
struct Remap {
    double a = 0.0;
    double b = 1.0;
    double c = 1.0;

    [[nodiscard]] double operator()(double visibility) const;
};

// The remap that brings an occlusion image nearest to the truth, by root mean square. It shows how accurate
// a method is apart from constant factors. The same images always give the same remap, and its error is
// never larger than without one. No remap where no truth is known. Throws std::invalid_argument when the
// sizes disagree.
[[nodiscard]] Remap best_remap(std::span<const float> occlusion, std::span<const float> truth);

// The occlusion image after a remap.
[[nodiscard]] std::vector<float> remapped(std::span<const float> occlusion, const Remap& remap);

}  // namespace gloam::effect
