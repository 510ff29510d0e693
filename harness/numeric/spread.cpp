// SPDX-License-Identifier: MIT
#include "numeric/spread.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
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

}  // namespace gloam::numeric
