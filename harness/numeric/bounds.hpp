// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>

namespace gloam::numeric {

// A set of results: every real number from low to high, infinities included if they are ends, and NaN if
// `nan` is set. It contains no number if low > high. NaN is stored separately, so that neither hides the
// other.
struct Bounds {
    // Without initialisers, because GLM's vectors hold their components in unions, which require trivial
    // types.
    double low;
    double high;
    bool nan;

    [[nodiscard]] static constexpr Bounds anything() {
        return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), true};
    }
    [[nodiscard]] static constexpr Bounds only_nan() {
        return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), true};
    }
    [[nodiscard]] static constexpr Bounds point(double x) { return {x, x, false}; }

    [[nodiscard]] constexpr bool empty() const { return low > high; }
    [[nodiscard]] constexpr bool is_point() const { return low == high && !nan; }
    [[nodiscard]] constexpr bool is_anything() const {
        return nan && low == -std::numeric_limits<double>::infinity() &&
               high == std::numeric_limits<double>::infinity();
    }
    // Whether a result is in the set.
    [[nodiscard]] constexpr bool contains(double x) const { return x != x ? nan : low <= x && x <= high; }
    [[nodiscard]] constexpr bool contains(const Bounds& other) const {
        return (nan || !other.nan) && (other.empty() || (low <= other.low && other.high <= high));
    }

    friend constexpr bool operator==(const Bounds&, const Bounds&) = default;
};

// The smallest bounds that contain both.
[[nodiscard]] constexpr Bounds hull(const Bounds& a, const Bounds& b) {
    return {std::min(a.low, b.low), std::max(a.high, b.high), a.nan || b.nan};
}

}  // namespace gloam::numeric
