// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

namespace gloam::numeric {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace gloam::numeric
