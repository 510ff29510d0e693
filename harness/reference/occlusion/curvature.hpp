// SPDX-License-Identifier: MIT
#pragma once

#include "reference/numeric/inverse_trigonometry.hpp"
#include "reference/numeric/square_root.hpp"
#include "reference/sampling/unit_interval.hpp"

namespace gloam::reference {

template <class T>
T gloam_occlusion_bowl(T a, T b) {
    const T product = a * b;
    const T size = gloam_sqrt((T(1) + a * a) * (T(1) + b * b));
    const T sum = a + b;
    const T part = product > T(1) ? T(0.5) * sum * (sum / (size + (product - T(1))))
                                  : T(0.5) * (size + (T(1) - product));
    return gloam_unit_interval(T(1) - gloam_sqrt(part) / size);
}

template <class T>
T gloam_occlusion_saddle(T a, T b) {
    const T t = gloam_sqrt(a / -b);
    const T size = gloam_sqrt((T(1) + a * a) * (T(1) + b * b));
    vec2<T> root(gloam_sqrt(T(0.5) * (size + (T(1) - a * b))), T(0));
    root.y = T(0.5) * (a + b) / root.x;
    const vec2<T> w = t / (T(1) + a * a) * vec2<T>(root.x + a * root.y, root.y - a * root.x);
    const T above = w.x * w.x + (T(1) + w.y) * (T(1) + w.y);
    const T below = w.x * w.x + (T(1) - w.y) * (T(1) - w.y);
    const vec2<T> arc(T(0.5) * gloam_atan2(T(2) * w.x, T(1) - dot(w, w)), T(0.25) * log(above / below));
    const T two_over_pi = exact_number<T> ? T(2) / pi<T>() : T(0.636619772);
    return gloam_unit_interval(two_over_pi * (gloam_atan(t) - dot(arc, root) / size));
}

template <class T>
T gloam_occlusion_curvature(T k_1, T k_2, T radius) {
    const bool ordered = k_1 > k_2;
    const T larger = T(0.5) * radius * (ordered ? k_1 : k_2);
    const T smaller = T(0.5) * radius * (ordered ? k_2 : k_1);
    if (!(radius > T(0) && larger > T(0) && (smaller >= T(0) || smaller < T(0)))) return T(0);
    const T a = min(larger, T(4096));
    const T b = clamp(smaller, T(-4096), T(4096));
    return b >= T(-1e-4) ? gloam_occlusion_bowl(a, b) : gloam_occlusion_saddle(a, b);
}

}  // namespace gloam::reference
