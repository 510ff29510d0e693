// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

namespace detail {

// Sum of the digits' values, as written: a_0 / b + a_1 / b^2 + ...
template <class T>
T mirrored_digits(unsigned index, unsigned base) {
    T value(0);
    T place(1);
    for (unsigned rest = index % 16777216U; rest > 0U; rest /= base) {
        place = place / T(static_cast<double>(base));
        value = value + T(static_cast<double>(rest % base)) * place;
    }
    return value;
}

}  // namespace detail

template <class T = double>
T gloam_radical_inverse_base2(unsigned index) {
    return detail::mirrored_digits<T>(index, 2U);
}

template <class T = double>
T gloam_radical_inverse(unsigned index, unsigned base) {
    return detail::mirrored_digits<T>(index, base < 2U ? 2U : (base > 16777216U ? 16777216U : base));
}

}  // namespace gloam::reference
