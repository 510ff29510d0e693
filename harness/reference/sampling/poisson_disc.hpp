// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "reference/math.hpp"

namespace gloam::reference {

// The points as the GLSL comment defines them, rounded to float.
inline std::array<glm::vec2, 64> poisson_disc_points() {
    constexpr std::size_t angles = 4096;
    std::array<glm::dvec2, 64> points{};
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::size_t reversed = 0;
        for (std::size_t bit = 0; bit < 6; ++bit) reversed |= ((i >> bit) & 1U) << (5U - bit);
        const double radius = std::sqrt((static_cast<double>(reversed) + 0.5) / 64.0);
        double farthest = -1.0;
        for (std::size_t a = 0; a < angles; ++a) {
            const double angle = 2.0 * std::numbers::pi * static_cast<double>(a) / angles;
            const glm::dvec2 candidate = radius * glm::dvec2(std::cos(angle), std::sin(angle));
            double nearest = 4.0;
            for (std::size_t j = 0; j < i; ++j) {
                const glm::dvec2 between = candidate - points.at(j);
                nearest = std::min(nearest, glm::dot(between, between));
            }
            if (nearest <= farthest + 1e-9) continue;  // ties: the first angle
            farthest = nearest;
            points.at(i) = candidate;
        }
    }
    std::array<glm::vec2, 64> rounded{};
    const auto clean = [](double x) { return std::abs(x) < 1e-12 ? 0.0F : static_cast<float>(x); };
    std::ranges::transform(points, rounded.begin(),
                           [&](glm::dvec2 p) { return glm::vec2(clean(p.x), clean(p.y)); });
    return rounded;
}

inline dvec2 gloam_poisson_disc(unsigned index) {
    static const std::array<glm::vec2, 64> points = poisson_disc_points();
    const glm::vec2 point = points.at(index & 63U);
    return dvec2(point.x, point.y);
}

}  // namespace gloam::reference
