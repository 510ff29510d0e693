// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>

namespace gloam::effect {

// A number that was calculated numerically, and how far it may be off (a standard error).
struct Estimate {
    double value = 0.0;
    double error = 0.0;
};

// (contribution times weight, weight) at a point of [0, 1)^3.
using Integrand = std::function<glm::dvec2(const std::array<double, 3>&)>;

// The weighted mean of contributions over the unit cube, clamped to [0, 1] as an estimator's mean is: the
// integral of the first component over that of the second, 0 for no weight. By a lattice (multiples of the
// powers of the root of x^4 = x + 1), shifted eight times, whose spread is the error; the number of
// points is doubled until that is at most `tolerance`, or until it is 2^17 a shift. No point of it is one of
// a Halton sequence.
[[nodiscard]] Estimate expectation(const Integrand& integrand, double tolerance);

}  // namespace gloam::effect
