// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "numeric/bounds.hpp"

namespace gloam::check {

// All outputs that Vulkan's precision rules permit for one input.
struct Permitted {
    bool anything = false;                  // every value; also if there were too many paths
    std::size_t width = 0;                  // output words
    std::vector<numeric::Bounds> outcomes;  // for each path through the function: bounds of every output word

    [[nodiscard]] std::size_t count() const { return width == 0 ? 0 : outcomes.size() / width; }
    [[nodiscard]] std::span<const numeric::Bounds> outcome(std::size_t i) const {
        return std::span(outcomes).subspan(i * width, width);
    }
};

// More paths than this count as `anything`.
inline constexpr std::size_t most_paths = 256;

// The smallest bounds that contain every outcome, one for each output word.
[[nodiscard]] std::vector<numeric::Bounds> hull_of(const Permitted& permitted);

// The distance of an output from `want`, as a fraction of the distance from `want` to the end of its bounds
// on that side: 0 at `want`, 1 at the end, more outside. Infinity outside if the second distance is 0.
[[nodiscard]] double fraction_of_width(double got, double want, const numeric::Bounds& bounds);

}  // namespace gloam::check
