// SPDX-License-Identifier: MIT
#include "numeric/text.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>

namespace gloam::numeric {

std::string to_text(float x) {
    return fmt::format("{} (0x{:08x})", x, std::bit_cast<std::uint32_t>(x));
}

std::string to_text(double x) {
    // Versions of fmt write the hexadecimal 0 differently.
    if (x == 0.0) return std::signbit(x) ? "-0 (-0x0p+0)" : "0 (0x0p+0)";
    return fmt::format("{:.9g} ({:a})", x, x);
}

std::string to_short_text(double x) {
    constexpr double most = 1e6;
    return x > -most && x < most ? fmt::format("{:.2f}", x) : fmt::format("{:.2g}", x);
}

}  // namespace gloam::numeric
