// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/inverse_trigonometry.hpp"
#include "reference/numeric/square_root.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

inline double gloam_occlusion_bowl(double a, double b) {
    const double product = a * b;
    const double size = gloam_sqrt((1.0 + a * a) * (1.0 + b * b));
    const double sum = a + b;
    const double part =
        product > 1.0 ? 0.5 * sum * (sum / (size + (product - 1.0))) : 0.5 * (size + (1.0 - product));
    return gloam_unit_interval(1.0 - gloam_sqrt(part) / size);
}

inline double gloam_occlusion_saddle(double a, double b) {
    const double t = gloam_sqrt(a / -b);
    const double size = gloam_sqrt((1.0 + a * a) * (1.0 + b * b));
    dvec2 root(gloam_sqrt(0.5 * (size + (1.0 - a * b))), 0.0);
    root.y = 0.5 * (a + b) / root.x;
    const dvec2 w = t / (1.0 + a * a) * dvec2(root.x + a * root.y, root.y - a * root.x);
    const double above = w.x * w.x + (1.0 + w.y) * (1.0 + w.y);
    const double below = w.x * w.x + (1.0 - w.y) * (1.0 - w.y);
    const dvec2 arc(0.5 * gloam_atan2(2.0 * w.x, 1.0 - dot(w, w)), 0.25 * log(above / below));
    const double two_over_pi = 2.0 / pi;
    return gloam_unit_interval(two_over_pi * (gloam_atan(t) - dot(arc, root) / size));
}

inline double gloam_occlusion_curvature(double k_1, double k_2, double radius) {
    const bool ordered = k_1 > k_2;
    const double larger = 0.5 * radius * (ordered ? k_1 : k_2);
    const double smaller = 0.5 * radius * (ordered ? k_2 : k_1);
    if (!(radius > 0.0 && larger > 0.0 && (smaller >= 0.0 || smaller < 0.0))) return 0.0;
    const double a = min(larger, 4096.0);
    const double b = clamp(smaller, -4096.0, 4096.0);
    return b >= -1e-4 ? gloam_occlusion_bowl(a, b) : gloam_occlusion_saddle(a, b);
}

}  // namespace gloam::reference
