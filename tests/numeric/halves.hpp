// SPDX-License-Identifier: MIT
#pragma once

// Every float16, by its bits: an account of the format that shares nothing with the code under test.
#include "support/test.hpp"

namespace gloam::numeric::halves {

inline double decode(std::uint16_t bits) {
    const int exponent = (bits >> 10) & 31;
    const int fraction = bits & 1023;
    const double sign = (bits >> 15) != 0 ? -1.0 : 1.0;
    if (exponent == 31) {
        return fraction == 0 ? sign * std::numeric_limits<double>::infinity()
                             : std::numeric_limits<double>::quiet_NaN();
    }
    if (exponent == 0) return sign * fraction / 16777216.0;
    return sign * std::pow(2.0, exponent - 15) * (1.0 + fraction / 1024.0);
}

// All finite values in rising order, zero once.
inline const std::vector<double>& finite() {
    static const std::vector<double> all = [] {
        std::vector<double> values;
        for (std::uint32_t bits = 0; bits < 65536; ++bits) {
            const double value = decode(static_cast<std::uint16_t>(bits));
            if (std::isfinite(value)) values.push_back(value);
        }
        std::ranges::sort(values);
        values.erase(std::unique(values.begin(), values.end()), values.end());
        return values;
    }();
    return all;
}

// The neighbours of a real number: the number itself when it is one of them.
inline double at_or_below(double x) {
    const auto above = std::ranges::upper_bound(finite(), x);
    return above == finite().begin() ? -std::numeric_limits<double>::infinity() : *(above - 1);
}
inline double at_or_above(double x) {
    const auto found = std::ranges::lower_bound(finite(), x);
    return found == finite().end() ? std::numeric_limits<double>::infinity() : *found;
}

// The gap that a real number lies in; at a power of two the one below it.
inline double gap(double x) {
    const double magnitude = std::min(std::abs(x), finite().back());
    if (magnitude <= 0x1p-14) return 0x1p-24;
    const auto found = std::ranges::lower_bound(finite(), magnitude);
    return *found - *(found - 1);
}

// A few values from everywhere: each power of two, its neighbours, and some between.
inline std::vector<double> some() {
    std::vector<double> values{0.0, 0x1p-24, 65504.0, 1.0 / 1024 + 1.0, 3.0};
    for (int exponent = -24; exponent <= 15; exponent += 3) {
        for (const double factor : {1.0, 1.5, 1.3330078125, 1.9990234375}) {
            values.push_back(at_or_below(std::ldexp(factor, exponent)));
        }
    }
    const std::size_t count = values.size();
    for (std::size_t i = 0; i < count; ++i) values.push_back(-values[i]);
    return values;
}

}  // namespace gloam::numeric::halves
