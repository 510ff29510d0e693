// SPDX-License-Identifier: MIT
#include "numeric/spread.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace gloam::numeric {
namespace {

double quantile(const std::vector<double>& sorted, double q) {
    const double at = q * static_cast<double>(sorted.size() - 1);
    const auto lower = static_cast<std::size_t>(at);
    const std::size_t upper = std::min(lower + 1, sorted.size() - 1);
    return std::lerp(sorted[lower], sorted[upper], at - static_cast<double>(lower));
}

}  // namespace

Spread spread_of(std::span<const double> values) {
    std::vector<double> sorted;
    std::ranges::copy_if(values, std::back_inserter(sorted), [](double v) { return std::isfinite(v); });
    if (sorted.empty()) return {};
    std::ranges::sort(sorted);
    return {quantile(sorted, 0.5), quantile(sorted, 0.25), quantile(sorted, 0.75)};
}

double exponent_of(std::span<const std::pair<double, double>> points) {
    std::vector<std::pair<double, double>> logs;
    double mean_x = 0.0;
    double mean_y = 0.0;
    for (const auto& [x, y] : points) {
        if (!(std::isfinite(x) && std::isfinite(y) && x > 0.0 && y > 0.0)) continue;
        logs.emplace_back(std::log(x), std::log(y));
        mean_x += logs.back().first;
        mean_y += logs.back().second;
    }
    mean_x /= static_cast<double>(logs.size());
    mean_y /= static_cast<double>(logs.size());
    double xx = 0.0;
    double xy = 0.0;
    for (const auto& [x, y] : logs) {
        xx += (x - mean_x) * (x - mean_x);
        xy += (x - mean_x) * (y - mean_y);
    }
    return xx > 0.0 ? xy / xx : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace gloam::numeric
