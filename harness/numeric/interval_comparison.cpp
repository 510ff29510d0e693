// SPDX-License-Identifier: MIT
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "numeric/constants.hpp"
#include "numeric/interval.hpp"
#include "numeric/paths.hpp"

namespace gloam::numeric {
namespace {

constexpr int most_integers = 64;

// The answer; both are explored if both are possible. NaN alone makes every comparison false.
bool decide(bool may_be_true, bool may_be_false) {
    if (may_be_true != may_be_false) return may_be_true;
    return Paths::choose(2) == 0;
}

bool has_nan(const Interval& a, const Interval& b) {
    return a.may_be_nan() || b.may_be_nan();
}

bool is_nowhere(const Interval& a, const Interval& b) {
    return a.bounds().empty() || b.bounds().empty();
}

// Explores each integer to which x can be truncated. All must be between least and most.
double integer_within(const Interval& x, double least, double most) {
    const double low = std::trunc(x.low());
    const double high = std::trunc(x.high());
    if (x.may_be_nan() || !(low >= least && high <= most) || high - low >= most_integers)
        throw Paths::Undetermined{};
    const auto count = static_cast<std::size_t>(high - low) + 1;
    return low + static_cast<double>(Paths::choose(count));
}

// Counts float32 values from zero.
std::int64_t ordinal_of(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    const auto magnitude = static_cast<std::int64_t>(bits & 0x7fffffffU);
    return (bits >> 31U) != 0 ? -magnitude : magnitude;
}

}  // namespace

bool operator<(const Interval& a, const Interval& b) {
    if (is_nowhere(a, b)) return false;
    return decide(a.low() < b.high(), has_nan(a, b) || a.high() >= b.low());
}

bool operator<=(const Interval& a, const Interval& b) {
    if (is_nowhere(a, b)) return false;
    return decide(a.low() <= b.high(), has_nan(a, b) || a.high() > b.low());
}

bool operator>(const Interval& a, const Interval& b) {
    return b < a;
}

bool operator>=(const Interval& a, const Interval& b) {
    return b <= a;
}

bool operator==(const Interval& a, const Interval& b) {
    if (is_nowhere(a, b)) return false;
    const bool meet = a.low() <= b.high() && b.low() <= a.high();
    const bool same = a.low() == a.high() && b.low() == b.high() && a.low() == b.low();
    return decide(meet, has_nan(a, b) || !same);
}

bool operator!=(const Interval& a, const Interval& b) {
    return !(a == b);
}

bool is_nan(const Interval& x) {
    return decide(x.may_be_nan(), !x.bounds().empty());
}

bool is_infinite(const Interval& x) {
    const bool infinite = !x.bounds().empty() && (x.low() == -infinity || x.high() == infinity);
    const bool finite = !x.bounds().empty() && (x.low() < infinity && x.high() > -infinity);
    return decide(infinite, finite || x.may_be_nan());
}

bool is_finite(const Interval& x) {
    const bool infinite = !x.bounds().empty() && (x.low() == -infinity || x.high() == infinity);
    const bool finite = !x.bounds().empty() && (x.low() < infinity && x.high() > -infinity);
    return decide(finite, infinite || x.may_be_nan());
}

int to_int(const Interval& x) {
    return static_cast<int>(
        integer_within(x, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
}

unsigned to_uint(const Interval& x) {
    return static_cast<unsigned>(integer_within(x, 0.0, std::numeric_limits<unsigned>::max()));
}

std::uint32_t to_bits(const Interval& x) {
    if (x.may_be_nan() || x.bounds().empty()) throw Paths::Undetermined{};
    const std::int64_t low = ordinal_of(static_cast<float>(x.low()));
    const std::int64_t high = ordinal_of(static_cast<float>(x.high()));
    if (high - low >= most_integers) throw Paths::Undetermined{};
    const bool has_zero = low <= 0 && high >= 0;
    const auto count = static_cast<std::size_t>(high - low) + (has_zero ? 2U : 1U);
    const std::size_t chosen = Paths::choose(count);
    if (has_zero && chosen + 1 == count) return 0x80000000U;
    const std::int64_t ordinal = low + static_cast<std::int64_t>(chosen);
    return ordinal < 0 ? static_cast<std::uint32_t>(-ordinal) | 0x80000000U
                       : static_cast<std::uint32_t>(ordinal);
}

}  // namespace gloam::numeric
