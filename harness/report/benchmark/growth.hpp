// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <utility>

namespace gloam::report {

// The exponent e of y ~ x^e that fits points best: least squares on logarithmic axes. Points without two
// positive, finite numbers are left out; NaN for fewer than two different x.
[[nodiscard]] double exponent_of(std::span<const std::pair<double, double>> points);

// The name of the plot of what grows, for a file: "scaling-radius-in-pixels".
[[nodiscard]] std::string growth_plot_name(const std::string& of);

}  // namespace gloam::report
