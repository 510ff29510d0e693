// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <utility>

namespace gloam::report {

// The exponent e of y ~ x^e with the best fit: least squares on logarithmic axes. Points without two
// positive, finite numbers are skipped; NaN for fewer than two different x.
[[nodiscard]] double exponent_of(std::span<const std::pair<double, double>> points);

// The file name of the plot of a quantity: "scaling-radius-in-pixels".
[[nodiscard]] std::string growth_plot_name(const std::string& of);

}  // namespace gloam::report
