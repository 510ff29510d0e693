// SPDX-License-Identifier: MIT
#pragma once

#include <glm/mat2x2.hpp>
#include <glm/mat2x3.hpp>
#include <glm/mat2x4.hpp>
#include <glm/mat3x2.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat3x4.hpp>
#include <glm/mat4x2.hpp>
#include <glm/mat4x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "numeric/interval.hpp"

// Sums of products on vectors of intervals. GLSL's dot and matrix products inherit their precision from the
// sum of products in any order, but GLM's generic operators have one order. These functions take the union
// over all orders.
namespace gloam::numeric {

template <glm::length_t N>
[[nodiscard]] Interval sum_in_any_order(const glm::vec<N, Interval>& p) {
    if constexpr (N == 1) {
        return p[0];
    } else if constexpr (N == 2) {
        return p[0] + p[1];
    } else if constexpr (N == 3) {
        return any_of((p[0] + p[1]) + p[2], any_of((p[0] + p[2]) + p[1], (p[1] + p[2]) + p[0]));
    } else {
        static_assert(N == 4);
        const auto without = [&p](glm::length_t last, glm::length_t a, glm::length_t b, glm::length_t c) {
            return sum_in_any_order(glm::vec<3, Interval>(p[a], p[b], p[c])) + p[last];
        };
        const auto pairs = [&p](glm::length_t a, glm::length_t b, glm::length_t c, glm::length_t d) {
            return (p[a] + p[b]) + (p[c] + p[d]);
        };
        const Interval chains = any_of(any_of(without(3, 0, 1, 2), without(2, 0, 1, 3)),
                                       any_of(without(1, 0, 2, 3), without(0, 1, 2, 3)));
        return any_of(chains, any_of(pairs(0, 1, 2, 3), any_of(pairs(0, 2, 1, 3), pairs(0, 3, 1, 2))));
    }
}

template <glm::length_t N>
[[nodiscard]] Interval dot(const glm::vec<N, Interval>& a, const glm::vec<N, Interval>& b) {
    return sum_in_any_order(a * b);
}

namespace detail {

template <glm::length_t C, glm::length_t R>
[[nodiscard]] glm::vec<R, Interval> product(const glm::mat<C, R, Interval>& m,
                                            const glm::vec<C, Interval>& v) {
    glm::vec<R, Interval> result;
    for (glm::length_t row = 0; row < R; ++row) {
        glm::vec<C, Interval> products;
        for (glm::length_t column = 0; column < C; ++column) products[column] = m[column][row] * v[column];
        result[row] = sum_in_any_order(products);
    }
    return result;
}

template <glm::length_t C, glm::length_t R>
[[nodiscard]] glm::vec<C, Interval> product(const glm::vec<R, Interval>& v,
                                            const glm::mat<C, R, Interval>& m) {
    glm::vec<C, Interval> result;
    for (glm::length_t column = 0; column < C; ++column) result[column] = dot(v, m[column]);
    return result;
}

template <glm::length_t C, glm::length_t R, glm::length_t K>
[[nodiscard]] glm::mat<K, R, Interval> product(const glm::mat<C, R, Interval>& a,
                                               const glm::mat<K, C, Interval>& b) {
    glm::mat<K, R, Interval> result;
    for (glm::length_t column = 0; column < K; ++column) result[column] = product(a, b[column]);
    return result;
}

}  // namespace detail

using IntervalVec2 = glm::vec<2, Interval>;
using IntervalVec3 = glm::vec<3, Interval>;
using IntervalVec4 = glm::vec<4, Interval>;
using IntervalMat2 = glm::mat<2, 2, Interval>;
using IntervalMat3 = glm::mat<3, 3, Interval>;
using IntervalMat4 = glm::mat<4, 4, Interval>;

// Not templates, so that overload resolution prefers them to GLM's.
[[nodiscard]] inline IntervalVec2 operator*(const IntervalMat2& m, const IntervalVec2& v) {
    return detail::product(m, v);
}
[[nodiscard]] inline IntervalVec3 operator*(const IntervalMat3& m, const IntervalVec3& v) {
    return detail::product(m, v);
}
[[nodiscard]] inline IntervalVec4 operator*(const IntervalMat4& m, const IntervalVec4& v) {
    return detail::product(m, v);
}
[[nodiscard]] inline IntervalVec2 operator*(const IntervalVec2& v, const IntervalMat2& m) {
    return detail::product(v, m);
}
[[nodiscard]] inline IntervalVec3 operator*(const IntervalVec3& v, const IntervalMat3& m) {
    return detail::product(v, m);
}
[[nodiscard]] inline IntervalVec4 operator*(const IntervalVec4& v, const IntervalMat4& m) {
    return detail::product(v, m);
}
[[nodiscard]] inline IntervalMat2 operator*(const IntervalMat2& a, const IntervalMat2& b) {
    return detail::product(a, b);
}
[[nodiscard]] inline IntervalMat3 operator*(const IntervalMat3& a, const IntervalMat3& b) {
    return detail::product(a, b);
}
[[nodiscard]] inline IntervalMat4 operator*(const IntervalMat4& a, const IntervalMat4& b) {
    return detail::product(a, b);
}

}  // namespace gloam::numeric
