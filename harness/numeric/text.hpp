// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace gloam::numeric {

// Shortest decimal that is read as the same value, and the exact bits: "0.1 (0x3dcccccd)".
[[nodiscard]] std::string to_text(float x);
// Decimal with 9 significant digits, and the exact hexadecimal value: "0.1 (0x1.999999999999ap-4)".
[[nodiscard]] std::string to_text(double x);

// A fraction of what is allowed, or another number near 1: two digits behind the point, at most six in front
// of it: "0.68", "1.5e+41".
[[nodiscard]] std::string to_short_text(double x);

}  // namespace gloam::numeric
