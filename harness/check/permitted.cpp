// SPDX-License-Identifier: MIT
#include "check/permitted.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gloam::check {

std::vector<numeric::Bounds> hull_of(const Permitted& permitted) {
    if (permitted.anything) return std::vector(permitted.width, numeric::Bounds::anything());
    std::vector<numeric::Bounds> all(permitted.outcome(0).begin(), permitted.outcome(0).end());
    for (std::size_t i = 1; i < permitted.count(); ++i) {
        std::ranges::transform(all, permitted.outcome(i), all.begin(), numeric::hull);
    }
    return all;
}

double fraction_of_width(double got, double want, const numeric::Bounds& bounds) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (std::isnan(got)) return bounds.nan ? 0.0 : infinity;
    if (bounds.empty()) return infinity;
    const bool inside = bounds.contains(got);
    // If `want` or `got` is not finite, there is no distance to measure; only inside or outside is known.
    if (!std::isfinite(want) || !std::isfinite(got)) return inside ? 0.0 : infinity;
    const double center = std::clamp(want, bounds.low, bounds.high);
    const double distance = std::abs(got - center);
    if (distance == 0.0) return 0.0;
    const double width = got > center ? bounds.high - center : center - bounds.low;
    return inside ? std::min(distance / width, 1.0) : distance / width;
}

}  // namespace gloam::check
