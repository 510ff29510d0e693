// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace gloam::numeric {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double largest_float = std::numeric_limits<float>::max();

}  // namespace gloam::numeric
