// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>

namespace gloam::effect {

// A numerically calculated number and its standard error.
struct Estimate {
    double value = 0.0;
    double error = 0.0;
};

// A function of a point of [0, 1)^3. Returns (contribution times weight, weight).
using Integrand = std::function<glm::dvec2(const std::array<double, 3>&)>;

// The weighted mean of contributions over the unit cube: the integral of the first component divided by that
// of the second, clamped to [0, 1] as an estimator's mean is; 0 if there is no weight.
// The points are a lattice (multiples of the powers of the root of x^4 = x + 1) with eight shifts, whose
// spread is the error. The number of points is doubled until the error is at most `tolerance`, or until there
// are 2^17 points for each shift. The points differ from those of any Halton sequence.
[[nodiscard]] Estimate expectation(const Integrand& integrand, double tolerance);

}  // namespace gloam::effect
