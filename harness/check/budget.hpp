// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace gloam::check {

// The largest permitted difference from the reference: an output passes if its error is at most `ulp` units
// in the last place, or at most `absolute`. Integers and bools must be equal.
struct Budget {
    double ulp = 0.0;
    double absolute = 0.0;
    // No forward bound exists where the function is discontinuous. Then a result also passes if it is within
    // the budget for inputs that are moved by at most this many ULP each. Inputs that are small whole numbers
    // stay: a count, or the end of a range, is meant exactly.
    int backward_ulp = 0;
    // Measures each vector or matrix in the ULP of its largest component, not in each component's own.
    bool of_largest_component = false;
};

// The budget as text: "4 ulp or 1e-07", "exact", "2 ulp at inputs within 1 ulp".
[[nodiscard]] std::string to_text(const Budget& budget);

}  // namespace gloam::check
