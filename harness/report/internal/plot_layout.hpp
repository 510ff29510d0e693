// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/plot.hpp"

namespace gloam::report::internal {

// Part of a logarithmic axis; both positive.
struct LogRange {
    double low = 1.0;
    double high = 10.0;

    // 0 at low, 1 at high.
    [[nodiscard]] double at(double value) const;
};

// Around the values that are finite and positive, and a little beyond; a decade where there are none.
[[nodiscard]] LogRange range_around(const std::vector<double>& values);

// Values to write beside an axis: 1, 2 and 5 of each decade, and more of them where the range is short.
[[nodiscard]] std::vector<double> tics_of(const LogRange& range);

// A text beside its point; both as parts of the plot's width and height, from the lower left.
struct PlacedLabel {
    std::string text;
    std::pair<double, double> point;
    std::pair<double, double> at;  // of the text's left middle
};

// The labels of all curves, beside their points, where none covers another or reaches beyond the plot, as far
// as there is room. Points that are not positive have none.
[[nodiscard]] std::vector<PlacedLabel> placed_labels(const Plot& plot, const LogRange& x, const LogRange& y);

}  // namespace gloam::report::internal
