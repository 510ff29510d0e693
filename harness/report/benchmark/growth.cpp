// SPDX-License-Identifier: MIT
#include "report/benchmark/growth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/text.hpp"
namespace gloam::report {

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

std::string growth_plot_name(const std::string& of) {
    std::string name = "scaling-" + of;
    std::erase(name, ',');
    std::ranges::replace(name, ' ', '-');
    return base::file_name_of(name);
}

}  // namespace gloam::report
