// SPDX-License-Identifier: MIT
#pragma once

#include "numeric/interval.hpp"

namespace gloam::numeric {

// All results that Vulkan permits where an operation may be contracted with others and rearranged (no
// NoContraction): sums, products and quotients may then be evaluated in any order that real numbers allow,
// and with fewer roundings. A value is kept as the polynomial that it is of its leaves (inputs, and results
// of operations that cannot be rearranged): the bounds that the order of the shader gives, and what bounds
// the rounding errors of every other order. Expressions that add and subtract, or multiply and divide by,
// what the shader does not name are not covered.
class Rearranged {
  public:
    Rearranged() = default;
    // A value that takes part as a whole.
    explicit Rearranged(const Interval& leaf);

    // Everything permitted.
    [[nodiscard]] Interval interval() const;

    friend Rearranged operator-(const Rearranged& x);
    friend Rearranged operator+(const Rearranged& a, const Rearranged& b);
    friend Rearranged operator-(const Rearranged& a, const Rearranged& b);
    friend Rearranged operator*(const Rearranged& a, const Rearranged& b);
    friend Rearranged operator/(const Rearranged& a, const Rearranged& b);

  private:
    Interval in_order_;       // in the order of the shader
    double magnitude_ = 0.0;  // the sum of the magnitudes of the polynomial's terms
    double largest_ = 1.0;    // that any partial result can reach
    double grid_ = 0.0;       // a power of two that all terms are multiples of; 0: none known
    double terms_ = 1.0;
    double roundings_ = 0.0;  // of one term, by its products and quotients
    int operations_ = 0;
    bool half_ = false;  // some operation had the precision of float16
};

}  // namespace gloam::numeric
