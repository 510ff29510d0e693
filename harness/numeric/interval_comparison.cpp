// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "numeric/constants.hpp"
#include "numeric/interval.hpp"
#include "numeric/paths.hpp"

namespace gloam::numeric {
namespace {

constexpr int most_integers = 64;

// The answer, explored where both are possible. NaN alone makes every comparison false.
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
    const double low = std::trunc(x.low());
    const double high = std::trunc(x.high());
    const bool inside = low >= std::numeric_limits<int>::min() && high <= std::numeric_limits<int>::max();
    if (x.may_be_nan() || !inside || high - low >= most_integers) throw Paths::Undetermined{};
    const auto count = static_cast<std::size_t>(high - low) + 1;
    return static_cast<int>(low) + static_cast<int>(Paths::choose(count));
}

}  // namespace gloam::numeric
