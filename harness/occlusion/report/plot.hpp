// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gloam::report {

enum class CurveStyle {
    line,        // with its points
    points,      // alone
    background,  // small grey points, behind the others
    steps        // a thick black staircase, constant up to the next point: a front
};

// A line of a plot. A y that is not finite leaves a gap.
struct Curve {
    std::string name;
    std::vector<std::pair<double, double>> points;
    CurveStyle style = CurveStyle::line;
    std::vector<std::string> labels{};  // beside the points: one for each, or none
};

struct Plot {
    std::string title;
    std::string x;  // titles of the axes, with units
    std::string y;
    bool logarithmic = false;  // both axes
    std::vector<Curve> curves;
};

// The plot as an SVG. gnuplot, which must be installed, draws it. Texts can contain any characters. Throws
// std::runtime_error if gnuplot is missing or fails, std::invalid_argument for a plot without a point or with
// another number of labels than points.
[[nodiscard]] std::string to_svg(const Plot& plot);

// The same as a PNG.
[[nodiscard]] std::string to_png(const Plot& plot);

}  // namespace gloam::report
