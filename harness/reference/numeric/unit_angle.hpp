// SPDX-License-Identifier: MIT
#pragma once

#include "reference/math.hpp"

namespace gloam::reference {

template <class T>
T gloam_unit_angle(vec2<T> direction) {
    if constexpr (exact_number<T>) return atan2(direction.y, direction.x);
    const bool steep = abs(direction.x) < direction.y;
    const T m = steep ? direction.x : direction.y;
    const T z = m * m;
    const T p = T(0.0390092656) + z * (T(0.0605309047) + z * (T(-0.0547225587) + z * T(0.100911587)));
    const T arc = m + (m * z) * (T(0.166653737) + z * (T(0.0754709542) + z * p));
    if (steep) return T(1.570796327) - arc;
    return direction.x < T(0) ? T(3.141592654) - arc : arc;
}

}  // namespace gloam::reference
