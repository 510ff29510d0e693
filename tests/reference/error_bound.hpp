// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <stdexcept>

// A number type that proves how far any conforming float32 arithmetic may end from exact arithmetic, over a
// whole box of inputs at once: beside the value it carries the range over the box and a bound of the error.
// Constants are the float32 that a compiler writes.
namespace gloam::reference::test {

class Bounded {
  public:
    Bounded() = default;
    explicit Bounded(double constant) : Bounded(static_cast<float>(constant), 0.0) {}
    template <std::integral Integer>
    explicit Bounded(Integer value) : Bounded(static_cast<double>(value), 0.0) {}

    // Every input from low to high.
    static Bounded box(double low, double high) {
        Bounded b((low + high) / 2.0, 0.0);
        b.low = low;
        b.high = high;
        return b;
    }
    [[nodiscard]] bool is_exactly(double x) const { return low == x && high == x && error == 0.0; }
    [[nodiscard]] bool is_power_of_two() const {
        int exponent = 0;
        return is_exactly(high) && std::abs(std::frexp(high, &exponent)) == 0.5;
    }
    [[nodiscard]] double size() const { return std::max(std::abs(low), std::abs(high)); }

    long double value = 0.0L;  // by exact arithmetic, in the middle of the box
    double low = 0.0;          // by exact arithmetic, over the box
    double high = 0.0;
    double error = 0.0;  // at most, of a conforming device against exact arithmetic

    // A result: what comes of the operands' errors, and `ulps` of its own. An ULP is at most 2^-23 of the
    // value; a subnormal may be flushed.
    static Bounded result(long double value, double low, double high, double inherited, double ulps) {
        Bounded b;
        b.value = value;
        b.low = low - 1e-15 * std::abs(low);  // the bounds themselves are rounded as doubles
        b.high = high + 1e-15 * std::abs(high);
        const double largest = b.size() + inherited;
        const double ulp = largest > 0x1p-126 ? std::ldexp(1.0, std::ilogb(largest) - 23) : 0.0;
        b.error = inherited + (ulps > 0.0 ? ulps * ulp + 0x1p-126 : 0.0);
        return b;
    }

  private:
    Bounded(double exact, double error_) : value(exact), low(exact), high(exact), error(error_) {}
};

inline Bounded operator-(const Bounded& x) {
    return Bounded::result(-x.value, -x.high, -x.low, x.error, 0.0);
}
inline Bounded operator+(const Bounded& a, const Bounded& b) {
    if (a.is_exactly(0.0)) return b;
    if (b.is_exactly(0.0)) return a;
    return Bounded::result(a.value + b.value, a.low + b.low, a.high + b.high, a.error + b.error, 1.0);
}
inline Bounded operator-(const Bounded& a, const Bounded& b) {
    return a + -b;
}
inline Bounded operator*(const Bounded& a, const Bounded& b) {
    const auto [low, high] = std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
    const double inherited = a.size() * b.error + b.size() * a.error + a.error * b.error;
    const bool exact = a.is_power_of_two() || b.is_power_of_two();
    return Bounded::result(a.value * b.value, low, high, inherited, exact ? 0.0 : 1.0);
}
// Vulkan: 2.5 ULP. The operands are positive here.
inline Bounded operator/(const Bounded& a, const Bounded& b) {
    if (!(a.low >= 0.0 && b.low > b.error)) throw std::domain_error("quotient of a number that may be 0");
    const double high = a.high / b.low;
    const double inherited = (a.error + high * b.error) / (b.low - b.error);
    return Bounded::result(a.value / b.value, a.low / b.high, high, inherited, 2.5);
}
// Vulkan: 2 ULP.
inline Bounded inversesqrt(const Bounded& x) {
    const double least = x.low - x.error;
    if (!(least > 0.0)) throw std::domain_error("inversesqrt of a number that may be 0");
    return Bounded::result(1.0L / std::sqrt(x.value), 1.0 / std::sqrt(x.high), 1.0 / std::sqrt(x.low),
                           0.5 * x.error / (least * std::sqrt(least)), 2.0);
}

// A comparison that the box leaves open is a mistake in the choice of boxes.
inline bool operator<(const Bounded& a, const Bounded& b) {
    if (a.high + a.error < b.low - b.error) return true;
    if (a.low - a.error >= b.high + b.error) return false;
    throw std::domain_error("a comparison is open over the box");
}
inline bool operator>(const Bounded& a, const Bounded& b) {
    return b < a;
}
inline bool operator>=(const Bounded& a, const Bounded& b) {
    return !(a < b);
}
inline bool operator<=(const Bounded& a, const Bounded& b) {
    return !(b < a);
}
inline Bounded abs(const Bounded& x) {
    if (x.low >= 0.0) return x;
    if (x.high <= 0.0) return -x;
    throw std::domain_error("abs of a number of either sign");
}
inline Bounded min(const Bounded& a, const Bounded& b) {
    return Bounded::result(std::min(a.value, b.value), std::min(a.low, b.low), std::min(a.high, b.high),
                           std::max(a.error, b.error), 0.0);
}
inline Bounded max(const Bounded& a, const Bounded& b) {
    return -min(-a, -b);
}
inline Bounded floor(const Bounded& x) {
    const double down = std::floor(x.low - x.error);
    if (down != std::floor(x.high + x.error)) throw std::domain_error("floor is open over the box");
    return Bounded(down);
}
inline int to_int(const Bounded& x) {
    return static_cast<int>(floor(x).value);
}

}  // namespace gloam::reference::test
