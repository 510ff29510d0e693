// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gloam::report {

// A line of a plot. A y that is not finite leaves a gap.
struct Curve {
    std::string name;
    std::vector<std::pair<double, double>> points;
};

struct Plot {
    std::string title;
    std::string x;  // what the axes show, with units
    std::string y;
    bool logarithmic = false;  // both axes
    std::vector<Curve> curves;
};

// The plot as an SVG, drawn by gnuplot, which must be installed. Throws std::runtime_error when it is not or
// cannot draw this, std::invalid_argument for a plot without a point.
[[nodiscard]] std::string to_svg(const Plot& plot);

}  // namespace gloam::report
