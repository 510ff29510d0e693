// SPDX-License-Identifier: MIT
#include "pictures/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace gloam::pictures {
namespace {

// The whole plot, and the part with points, in units of the SVG.
constexpr double width = 560.0;
constexpr double height = 400.0;
constexpr double left = 44.0;
constexpr double right = width - 16.0;
constexpr double top = 24.0;
constexpr double bottom = height - 40.0;

struct Box {
    double left, top, right, bottom;

    [[nodiscard]] bool meets(const Box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

// From values to places: a little more than the range of the values.
class Axes {
  public:
    explicit Axes(std::span<const PlotPoint> points) {
        const auto [near, far] = std::ranges::minmax(points, {}, &PlotPoint::x);
        const auto [low, high] = std::ranges::minmax(points, {}, &PlotPoint::y);
        x0 = near.x / 1.15;
        x1 = far.x * 1.15;
        step = high.y - low.y > 0.05 ? 0.02 : 0.01;
        y0 = std::floor(low.y / step) * step;
        y1 = std::ceil(high.y / step) * step;
        if (y1 <= y0) y1 = y0 + step;
    }

    [[nodiscard]] double x_of(double x) const {
        return left + (right - left) * std::log(x / x0) / std::log(x1 / x0);
    }
    [[nodiscard]] double y_of(double y) const { return bottom - (bottom - top) * (y - y0) / (y1 - y0); }

    double x0, x1, y0, y1, step;
};

std::string text_at(double x, double y, const char* kind, const std::string& text) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"{}\">{}</text>\n", x, y, kind, text);
}

// Lines of the grid with their values, and the titles of the axes.
std::string grid(const Axes& axes, const std::string& x_title, const std::string& y_title) {
    std::string svg;
    const auto line = [&](double x, double y, double to_x, double to_y) {
        svg += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", x, y, to_x,
                           to_y);
    };
    for (double y = axes.y0; y < axes.y1 + axes.step / 2; y += axes.step) {
        line(left, axes.y_of(y), right, axes.y_of(y));
        svg += text_at(left - 32, axes.y_of(y) + 4, "axis", fmt::format("{:.2f}", y));
    }
    for (double power = 1e-3; power < 1e6; power *= 10)
        for (const double x : {power, 2 * power, 5 * power}) {
            if (x < axes.x0 || x > axes.x1) continue;
            line(axes.x_of(x), top, axes.x_of(x), bottom);
            svg += text_at(axes.x_of(x) - 6, bottom + 16, "axis", fmt::format("{:g}", x));
        }
    return svg + text_at(0, top - 10, "axis", y_title) + text_at(left, height - 6, "axis", x_title);
}

// The place of a name beside its point that meets no box before it. Nothing
// where there is none, unless it must be named.
std::string name_of(const PlotPoint& point, double x, double y, std::vector<Box>& boxes) {
    const double length = 6.6 * static_cast<double>(point.name.size());
    const Box above{x - length / 2, y - 20, x + length / 2, y - 7};
    const Box beside{x + 7, y - 7, x + 7 + length, y + 6};
    const Box places[] = {point.own ? above : beside,
                          point.own ? beside : above,
                          {x - 7 - length, y - 7, x - 7, y + 6},
                          {x - length / 2, y + 7, x + length / 2, y + 20}};
    for (const Box& place : places) {
        const bool inside =
            place.left > left && place.right < width && place.top > 0 && place.bottom < bottom;
        const bool is_free = std::ranges::none_of(boxes, [&](const Box& box) { return box.meets(place); });
        if (!inside || !is_free) continue;
        boxes.push_back(place);
        return text_at(place.left, place.bottom - 2, point.own ? "own" : "name", point.name);
    }
    return point.own ? text_at(x + 7, y + 4, "own", point.name) : "";
}

}  // namespace

std::string to_plot_svg(std::span<const PlotPoint> points, const std::string& x_title,
                        const std::string& y_title) {
    const Axes axes(points);
    std::string svg = fmt::format(
        "<svg class=\"plot\" viewBox=\"0 0 {:g} {:g}\" role=\"img\" aria-label=\"{} over {}\">\n{}", width,
        height, y_title, x_title, grid(axes, x_title, y_title));
    std::vector<Box> boxes;
    std::string joined;
    std::string marks;
    for (const PlotPoint& point : points) {
        const double x = axes.x_of(point.x);
        const double y = axes.y_of(point.y);
        boxes.push_back({x - 4, y - 4, x + 4, y + 4});
        if (point.own) joined += fmt::format("{:.1f},{:.1f} ", x, y);
        marks += fmt::format(
            "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" class=\"{}\"><title>{}: {:.2f}, {:.3f}</title>"
            "</circle>\n",
            x, y, point.own ? 5 : 3.5, point.own ? "own" : "other", point.name, point.x, point.y);
    }
    std::string names;
    for (const bool own : {true, false})
        for (const PlotPoint& point : points)
            if (point.own == own) names += name_of(point, axes.x_of(point.x), axes.y_of(point.y), boxes);
    return svg + "<polyline points=\"" + joined + "\"/>\n" + marks + names + "</svg>\n";
}

}  // namespace gloam::pictures
