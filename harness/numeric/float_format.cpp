// SPDX-License-Identifier: MIT
#include "numeric/float_format.hpp"
#include "numeric/constants.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gloam::numeric {
namespace {

// The hardware knows float32; the result is corrected where it rounded the other way.
double float32_down(double x) {
    const auto nearest = static_cast<float>(x);
    if (static_cast<double>(nearest) <= x) return nearest;
    return std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

// The exponent of the last digit of the format's numbers around x.
int last_place(const FloatFormat& format, double x) {
    const int exponent = x == 0.0 ? format.min_exponent : std::ilogb(x);
    return std::max(exponent, format.min_exponent) - (format.precision - 1);
}

}  // namespace

double FloatFormat::smallest_subnormal() const {
    return std::ldexp(1.0, min_exponent - (precision - 1));
}

double FloatFormat::largest() const {
    return std::ldexp(2.0 - std::ldexp(1.0, 1 - precision), max_exponent);
}

double FloatFormat::round_down(double x) const {
    if (std::isinf(x)) return x;
    if (*this == float32) return float32_down(x);
    if (x > largest()) return largest();
    if (x < -largest()) return -infinity;
    const int place = last_place(*this, x);
    return std::ldexp(std::floor(std::ldexp(x, -place)), place);
}

double FloatFormat::round_up(double x) const {
    return -round_down(-x);
}

double FloatFormat::ulp(double x) const {
    const double magnitude = std::min(std::abs(x), largest());
    int place = last_place(*this, magnitude);
    const bool power_of_two = magnitude > smallest_normal() && std::ilogb(magnitude) <= max_exponent &&
                              magnitude == std::ldexp(1.0, std::ilogb(magnitude));
    if (power_of_two) --place;
    return std::ldexp(1.0, place);
}

}  // namespace gloam::numeric
