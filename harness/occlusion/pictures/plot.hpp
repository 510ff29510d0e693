// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace gloam::pictures {

// A point of a plot: what is measured of one thing.
struct PlotPoint {
    std::string name;
    double x = 0.0;  // > 0
    double y = 0.0;
    bool own = false;  // marked, named in any case, and joined by a line with the others of its kind
};

// An SVG element of points, x on a logarithmic axis, both from the least to the largest value. Every point
// tells its name and values (its title); beside it stands its name where there is place. The style is the
// page's: classes plot, axis, own and other. At least one point.
[[nodiscard]] std::string to_plot_svg(std::span<const PlotPoint> points, const std::string& x_title,
                                      const std::string& y_title);

}  // namespace gloam::pictures
