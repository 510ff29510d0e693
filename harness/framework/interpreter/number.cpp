// SPDX-License-Identifier: MIT
#include "interpreter/number.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "interpreter/internal/conversions.hpp"
#include "numeric/numbers.hpp"
#include "numeric/paths.hpp"

namespace gloam::interpreter {

std::uint32_t sign_of(const numeric::Interval& x) {
    const bool may_be_positive = x.may_be_nan() || x.high() >= 0.0;
    const bool may_be_negative = x.may_be_nan() || x.low() <= 0.0;
    if (may_be_positive && may_be_negative) return static_cast<std::uint32_t>(numeric::Paths::choose(2));
    return may_be_negative ? 1U : 0U;
}

namespace {

// The power of two whose float has the exponent of that magnitude: 0 for 0 and subnormal numbers.
double power_of(double magnitude) {
    constexpr double smallest_normal = 0x1p-126;
    constexpr double largest_power = 0x1p127;
    if (magnitude < smallest_normal) return 0.0;
    return std::min(std::exp2(std::ilogb(magnitude)), largest_power);
}

}  // namespace

numeric::Interval exponent_of(const numeric::Interval& x) {
    if (!numeric::is_finite(x)) return number_from_bits<numeric::Interval>(exponent_mask);
    const double low = std::abs(x.low());
    const double high = std::abs(x.high());
    const bool has_zero = x.low() <= 0.0 && x.high() >= 0.0;
    return numeric::Interval::within(has_zero ? 0.0 : power_of(std::min(low, high)),
                                     power_of(std::max(low, high)));
}

namespace internal {

// One of the possible halfs. Their bits increase with their magnitude; a subnormal may be flushed to zero.
Word HalfBits::operator()(const numeric::Interval& x) const {
    constexpr int most = 64;
    constexpr int sign = 0x8000;
    if (x.may_be_nan() || x.bounds().empty()) throw numeric::Paths::Undetermined{};
    const auto ordinal = [](double value) {
        const auto bits = static_cast<int>(base::to_half(static_cast<float>(value)));
        return (bits & sign) != 0 ? -(bits & ~sign) : bits;
    };
    const int low = ordinal(numeric::float16.round_down(x.low()));
    const int high = ordinal(numeric::float16.round_up(x.high()));
    if (high - low >= most) throw numeric::Paths::Undetermined{};
    std::vector<int> halfs;
    for (int taken = low; taken <= high; ++taken) halfs.push_back(taken < 0 ? -taken | sign : taken);
    const double normal = numeric::float16.smallest_normal();
    if (x.low() < normal && x.high() > -normal) halfs.insert(halfs.end(), {0, sign});
    return static_cast<Word>(halfs[numeric::Paths::choose(halfs.size())]);
}

}  // namespace internal
}  // namespace gloam::interpreter
