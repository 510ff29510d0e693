// SPDX-License-Identifier: MIT
#include "report/internal/plot_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gloam::report::internal {
namespace {

// Size of a label as parts of the plot, estimated generously.
constexpr double character = 0.0105;
constexpr double line_height = 0.036;
constexpr double gap = 0.008;  // between a point and its label

struct Box {
    double left = 0.0;
    double bottom = 0.0;
    double right = 0.0;
    double top = 0.0;
};

bool overlap(const Box& a, const Box& b) {
    return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

Box box_of(const std::pair<double, double>& at, const std::string& text) {
    const double width = character * static_cast<double>(text.size());
    return {at.first, at.second - 0.5 * line_height, at.first + width, at.second + 0.5 * line_height};
}

bool inside(const Box& box) {
    return box.left >= 0.0 && box.right <= 1.0 && box.bottom >= 0.0 && box.top <= 1.0;
}

// Candidate positions of a label: right or left of the point, slightly above or below, clear of a line
// through it, then at increasing distances.
std::vector<std::pair<double, double>> places_for(const std::pair<double, double>& point,
                                                  const std::string& text) {
    const double width = character * static_cast<double>(text.size());
    std::vector<std::pair<double, double>> places;
    for (int lines = 1; lines <= 12; ++lines) {
        for (const double side : {1.0, -1.0}) {
            const double y = point.second + side * 0.6 * line_height * lines;
            for (const double x : {point.first + gap, point.first - gap - width}) places.emplace_back(x, y);
        }
    }
    return places;
}

bool is_free(const Box& box, const std::vector<Box>& taken) {
    return inside(box) && std::ranges::none_of(taken, [&](const Box& other) { return overlap(box, other); });
}

}  // namespace

double LogRange::at(double value) const {
    return std::log(value / low) / std::log(high / low);
}

LogRange range_around(const std::vector<double>& values) {
    LogRange range{0.0, 0.0};
    for (const double value : values) {
        if (!std::isfinite(value) || value <= 0.0) continue;
        range.low = range.low == 0.0 ? value : std::min(range.low, value);
        range.high = std::max(range.high, value);
    }
    if (range.low == 0.0) return {};
    const double beyond = std::max(1.05, std::pow(range.high / range.low, 0.06));
    return {range.low / beyond, range.high * beyond};
}

std::vector<double> tics_of(const LogRange& range) {
    static constexpr std::array few{1.0, 2.0, 5.0};
    static constexpr std::array many{1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0};
    const bool is_short = range.high / range.low < 12.0;
    std::vector<double> tics;
    for (double decade = std::pow(10.0, std::floor(std::log10(range.low))); decade <= range.high;
         decade *= 10.0) {
        const auto add = [&](double step) {
            const double value = step * decade;
            if (value >= range.low && value <= range.high) tics.push_back(value);
        };
        is_short ? (void)std::ranges::for_each(many, add) : (void)std::ranges::for_each(few, add);
    }
    return tics;
}

std::vector<PlacedLabel> placed_labels(const Plot& plot, const LogRange& x, const LogRange& y) {
    std::vector<PlacedLabel> labels;
    std::vector<Box> taken;
    for (const Curve& curve : plot.curves) {
        for (std::size_t i = 0; i < curve.labels.size(); ++i) {
            const auto& [value, height] = curve.points[i];
            if (!(value > 0.0 && height > 0.0) || !std::isfinite(value) || !std::isfinite(height)) continue;
            labels.push_back({curve.labels[i], {x.at(value), y.at(height)}, {}});
            const auto& [px, py] = labels.back().point;
            taken.push_back({px - 0.5 * gap, py - 0.5 * gap, px + 0.5 * gap, py + 0.5 * gap});
        }
    }
    for (PlacedLabel& label : labels) {
        const auto places = places_for(label.point, label.text);
        const auto found = std::ranges::find_if(
            places, [&](const auto& place) { return is_free(box_of(place, label.text), taken); });
        label.at = found == places.end() ? places.front() : *found;
        taken.push_back(box_of(label.at, label.text));
    }
    return labels;
}

}  // namespace gloam::report::internal
