// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/plot.hpp"

namespace gloam::report::internal {

// A range of a logarithmic axis; both ends are positive.
struct LogRange {
    double low = 1.0;
    double high = 10.0;

    // Position of a value: 0 at low, 1 at high.
    [[nodiscard]] double at(double value) const;
};

// A range around the finite, positive values with a margin; a decade if there are none.
[[nodiscard]] LogRange range_around(const std::vector<double>& values);

// Values for an axis' labels: 1, 2 and 5 of each decade, and more if the range is short.
[[nodiscard]] std::vector<double> tics_of(const LogRange& range);

// A text beside its point; positions are parts of the plot's width and height, from the lower left.
struct PlacedLabel {
    std::string text;
    std::pair<double, double> point;
    std::pair<double, double> at;  // of the text's left middle
};

// Positions for the labels of all curves, beside their points, so that no label covers another or extends
// beyond the plot. Labels without room, and those of points that are not positive, are skipped.
[[nodiscard]] std::vector<PlacedLabel> placed_labels(const Plot& plot, const LogRange& x, const LogRange& y);

}  // namespace gloam::report::internal
