// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace gloam::report {

enum class CurveStyle {
    line,        // with its points
    points,      // alone
    background,  // small grey points: what the others stand among
    steps        // a thick black staircase, each point's value until the next: a front
};

// A line of a plot. A y that is not finite leaves a gap.
struct Curve {
    std::string name;
    std::vector<std::pair<double, double>> points;
    CurveStyle style = CurveStyle::line;
    std::vector<std::string> labels{};  // written beside the points, as many as there are; or none
};

struct Plot {
    std::string title;
    std::string x;  // what the axes show, with units
    std::string y;
    bool logarithmic = false;  // both axes
    std::vector<Curve> curves;
};

// The plot as an SVG, drawn by gnuplot, which must be installed; texts may hold anything. Throws
// std::runtime_error when it is not or cannot draw this, std::invalid_argument for a plot without a point or
// with labels of another number.
[[nodiscard]] std::string to_svg(const Plot& plot);

// The same as a PNG.
[[nodiscard]] std::string to_png(const Plot& plot);

}  // namespace gloam::report
