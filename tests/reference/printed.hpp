// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "numeric/random.hpp"
#include "reference/math.hpp"

namespace gloam::reference::test {

constexpr int draws = 2000;

// Calls check(random) for many states of one random generator.
template <class Check>
void for_random(Check check) {
    numeric::Random random(1);
    for (int i = 0; i < draws; ++i) check(random);
}

inline double log_uniform(numeric::Random& random, double low, double high) {
    return std::exp(random.uniform(std::log(low), std::log(high)));
}
inline dvec3 point3(numeric::Random& random, double extent = 1.0) {
    return dvec3(random.uniform(-extent, extent), random.uniform(-extent, extent),
                 random.uniform(-extent, extent));
}

// Equal but for the rounding of doubles, relative to the larger of the value and `scale`.
inline void expect_same(double got, double want, double scale = 0.0) {
    EXPECT_NEAR(got, want, 1e-12 * std::max(std::abs(want), scale));
}
// Vectors, relative to their largest component (or `scale`).
template <glm::length_t N>
void expect_same(const glm::vec<N, double>& got, const glm::vec<N, double>& want, double scale = 0.0) {
    for (glm::length_t i = 0; i < N; ++i) scale = std::max(scale, std::abs(want[i]));
    for (glm::length_t i = 0; i < N; ++i) expect_same(got[i], want[i], scale);
}

}  // namespace gloam::reference::test
