// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "reference/numeric/sincos.hpp"
#include "reference/sampling/radical_inverse.hpp"

namespace gloam::reference {

// The points as the GLSL comment defines them: at each radius the angle farthest from the points before.
inline std::vector<dvec2> poisson_disc_points() {
    std::vector<dvec2> points;
    for (unsigned i = 0; i < 64U; ++i) {
        const double radius = sqrt(gloam_radical_inverse(i, 2U) + 0.5 / 64.0);
        double farthest = -1.0;
        dvec2 best(0.0);
        for (int a = 0; a < 4096; ++a) {
            const dvec2 candidate = radius * on_circle(2.0 * pi * a / 4096.0);
            double nearest = 4.0;
            for (const dvec2& p : points) nearest = min(nearest, dot(candidate - p, candidate - p));
            if (nearest <= farthest + 1e-9) continue;  // ties: the first angle
            farthest = nearest;
            best = candidate;
        }
        points.push_back(best);
    }
    return points;
}

inline dvec2 gloam_poisson_disc(unsigned index) {
    static const std::vector<dvec2> points = poisson_disc_points();
    return glm::vec2(glm::round(points[index % 64U] * 1e12) / 1e12);
}

}  // namespace gloam::reference
