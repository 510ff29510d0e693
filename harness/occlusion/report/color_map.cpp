// SPDX-License-Identifier: MIT
#include "report/color_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gloam::report {
namespace {

using Triple = std::array<double, 3>;

// Linear sRGB of a colour in Oklab (Ottosson 2020).
Triple linear_from_oklab(double lightness, double a, double b) {
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

bool displayable(const Triple& rgb) {
    return std::ranges::all_of(rgb, [](double x) { return x >= 0.0 && x <= 1.0; });
}

std::uint8_t encoded(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double srgb = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255.0 * srgb));
}

}  // namespace

Color heat_color(double value) {
    const double t = value > 0.0 ? std::min(value, 1.0) : 0.0;
    const double lightness = 0.08 + 0.89 * t;
    const double hue = (285.0 + 180.0 * t) * std::numbers::pi / 180.0;
    // Reduces the chroma until the colour is displayable, because the lightness must not change.
    Triple rgb{};
    for (double chroma = 0.18; chroma > -0.005; chroma -= 0.005) {
        rgb = linear_from_oklab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
        if (displayable(rgb)) break;
    }
    return {encoded(rgb[0]), encoded(rgb[1]), encoded(rgb[2])};
}

}  // namespace gloam::report
