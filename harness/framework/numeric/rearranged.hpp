// SPDX-License-Identifier: MIT
#pragma once

#include "numeric/interval.hpp"

namespace gloam::numeric {

// All results that Vulkan permits for operations that may be contracted and rearranged (no NoContraction).
// Sums, products and quotients may then be evaluated in any order that is valid for real numbers, and with
// fewer roundings.
// A value is stored as a polynomial of its leaves, which are inputs and results of operations that cannot be
// rearranged. Stored are the bounds for the shader's order, and the quantities that bound the rounding errors
// of every other order. Expressions that add and subtract, or multiply and divide by, terms that are not in
// the shader are not covered.
class Rearranged {
  public:
    Rearranged() = default;
    // A leaf: a value that is not rearranged itself.
    explicit Rearranged(const Interval& leaf);

    // All permitted results.
    [[nodiscard]] Interval interval() const;

    friend Rearranged operator-(const Rearranged& x);
    friend Rearranged operator+(const Rearranged& a, const Rearranged& b);
    friend Rearranged operator-(const Rearranged& a, const Rearranged& b);
    friend Rearranged operator*(const Rearranged& a, const Rearranged& b);
    friend Rearranged operator/(const Rearranged& a, const Rearranged& b);

  private:
    Interval in_order_;        // for the shader's order
    double magnitude_ = 0.0;   // the sum of the magnitudes of the polynomial's terms
    double largest_ = 1.0;     // bound of any partial result
    double grid_ = 0.0;        // a power of two that divides all terms; 0: unknown
    double least_grid_ = 1.0;  // the same for all partial results, at most 1
    double terms_ = 1.0;
    double roundings_ = 0.0;  // of one term, by its products and quotients
    int operations_ = 0;
    const FloatFormat* format_ = nullptr;  // of its least precise operation
};

}  // namespace gloam::numeric
