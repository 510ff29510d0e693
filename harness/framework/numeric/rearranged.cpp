// SPDX-License-Identifier: MIT
#include "numeric/rearranged.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "numeric/numbers.hpp"
#include "numeric/paths.hpp"

namespace gloam::numeric {
namespace {

// A quotient has an error of 2.5 ULP, and may be a product with a reciprocal with the same error.
constexpr double quotient_roundings = 6.0;

// The largest power of two that divides x; 0 for 0 and for values that are not finite.
double lowest_bit(double x) {
    if (x == 0.0 || !std::isfinite(x)) return 0.0;
    int exponent = 0;
    const double fraction = std::frexp(std::abs(x), &exponent);
    const auto digits = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
    return std::ldexp(1.0, exponent - 53 + std::countr_zero(digits));
}

double largest_magnitude(const Bounds& x) {
    return x.empty() ? infinity : std::max(std::abs(x.low), std::abs(x.high));
}

// The least precise format of two operands and the running operation.
const FloatFormat* least_precise(const FloatFormat* a, const FloatFormat* b) {
    const FloatFormat* least = Paths::format() == float16 ? &float16 : &float32;
    for (const FloatFormat* other : {a, b})
        if (other != nullptr && other->precision < least->precision) least = other;
    return least;
}

double smallest_magnitude(const Bounds& x) {
    if (x.empty() || x.contains(0.0)) return 0.0;
    return std::min(std::abs(x.low), std::abs(x.high));
}

}  // namespace

Rearranged::Rearranged(const Interval& leaf) : in_order_(leaf) {
    const Bounds& bounds = leaf.bounds();
    magnitude_ = largest_magnitude(bounds);
    largest_ = std::max(1.0, magnitude_);
    if (bounds.is_point()) grid_ = bounds.low == 0.0 ? infinity : lowest_bit(bounds.low);
    least_grid_ = std::min(1.0, grid_);
}

Interval Rearranged::interval() const {
    if (operations_ < 2) return in_order_;  // one operation has one order
    const FloatFormat& format = *format_;
    const Bounds& bounds = in_order_.bounds();
    if (!(largest_ <= format.largest()) || bounds.empty()) return Interval::anything();
    const bool exact = magnitude_ <= std::ldexp(grid_, format.precision) &&
                       std::min(grid_, least_grid_) >= format.smallest_normal();
    if (exact) return in_order_;
    const double unit = std::ldexp(1.0, 1 - format.precision);
    const double count = terms_ - 1.0 + roundings_;
    const double slack = std::expm1(count * unit) * magnitude_ + count * format.smallest_normal() * largest_;
    // The difference is rounded, too.
    return Interval::within(enclose({std::nextafter(bounds.low - slack, -infinity),
                                     std::nextafter(bounds.high + slack, infinity), bounds.nan})
                                .bounds());
}

Rearranged operator-(const Rearranged& x) {
    Rearranged result = x;
    result.in_order_ = -x.in_order_;
    return result;
}

Rearranged operator+(const Rearranged& a, const Rearranged& b) {
    Rearranged result;
    result.in_order_ = a.in_order_ + b.in_order_;
    result.magnitude_ = a.magnitude_ + b.magnitude_;
    result.largest_ = a.largest_ + b.largest_;
    result.grid_ = std::min(a.grid_, b.grid_);
    result.least_grid_ = std::min(a.least_grid_, b.least_grid_);
    result.terms_ = a.terms_ + b.terms_;
    result.roundings_ = std::max(a.roundings_, b.roundings_);
    result.operations_ = a.operations_ + b.operations_ + 1;
    result.format_ = least_precise(a.format_, b.format_);
    return result;
}

Rearranged operator-(const Rearranged& a, const Rearranged& b) {
    return a + -b;
}

Rearranged operator*(const Rearranged& a, const Rearranged& b) {
    Rearranged result;
    result.in_order_ = a.in_order_ * b.in_order_;
    result.magnitude_ = a.magnitude_ * b.magnitude_;
    result.largest_ = a.largest_ * b.largest_;
    // If a factor has no grid, the product has none; if one is zero, nothing is lost.
    result.grid_ = a.grid_ == 0.0 || b.grid_ == 0.0 ? 0.0 : a.grid_ * b.grid_;
    result.least_grid_ = a.least_grid_ * b.least_grid_;
    result.terms_ = a.terms_ * b.terms_;
    result.roundings_ = a.roundings_ + b.roundings_ + 1.0;
    result.operations_ = a.operations_ + b.operations_ + 1;
    result.format_ = least_precise(a.format_, b.format_);
    return result;
}

Rearranged operator/(const Rearranged& a, const Rearranged& b) {
    Rearranged result;
    const Interval divisor = b.interval();
    const double smallest = smallest_magnitude(divisor.bounds());
    result.in_order_ = a.in_order_ / divisor;
    result.magnitude_ = a.magnitude_ / smallest;
    result.largest_ = a.largest_ * std::max(1.0, 1.0 / smallest);
    result.terms_ = a.terms_;
    result.roundings_ = a.roundings_ + quotient_roundings;
    result.operations_ = a.operations_ + 1;
    result.format_ = least_precise(a.format_, b.format_);
    return result;
}

}  // namespace gloam::numeric
