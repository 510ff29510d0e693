// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace gloam::check {

// How far a result may be from the reference: an output passes when its error is at most `ulp` units in the
// last place or at most `absolute`. Integers and bools must be equal.
struct Budget {
    double ulp = 0.0;
    double absolute = 0.0;
    // Where the function jumps, no forward bound exists; then a result also passes when it meets the bound
    // above for inputs moved by at most this many ULP each.
    int backward_ulp = 0;
    // Measure each vector or matrix in ULP of its largest component instead of each component's own.
    bool of_largest_component = false;
};

// "4 ulp or 1e-07", "exact", "2 ulp at inputs within 1 ulp".
[[nodiscard]] std::string to_text(const Budget& budget);

}  // namespace gloam::check
