// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <span>
#include <utility>

namespace gloam::numeric {

// A median with its quartiles. NaN without values.
struct Spread {
    double median = std::numeric_limits<double>::quiet_NaN();
    double low = std::numeric_limits<double>::quiet_NaN();   // lower quartile
    double high = std::numeric_limits<double>::quiet_NaN();  // upper quartile
};

// Median and quartiles, interpolated linearly between the values of the sorted list; the first value is the
// quantile 0, the last the quantile 1. Values that are not finite are skipped.
[[nodiscard]] Spread spread_of(std::span<const double> values);

// The exponent e of y ~ x^e with the best fit: least squares on logarithmic axes. Points without two
// positive, finite numbers are skipped; NaN for fewer than two different x.
[[nodiscard]] double exponent_of(std::span<const std::pair<double, double>> points);

}  // namespace gloam::numeric
