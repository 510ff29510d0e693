// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>
#include <span>

#include "interpreter/internal/arithmetic.hpp"
#include "numeric/interval.hpp"
#include "numeric/paths.hpp"

// Floats: sums of products, and the GLSL functions on vectors and matrices.
namespace gloam::interpreter::internal {

inline constexpr std::size_t most_components = 4;

// The result of a sum of products, which is NaN or infinite where an operand is.
template <class N>
[[nodiscard]] N of_finite(const Instruction& i, const N& result) {
    return assumed(i, result, result);
}

// The sum of up to four products. If it may be rearranged, every order is included.
template <class N>
[[nodiscard]] N sum(const std::array<N, most_components>& products, std::uint32_t count) {
    N all = products[0];
    for (std::uint32_t k = 1; k < count; ++k) {
        if constexpr (std::is_same_v<N, numeric::Rearranged>) {
            all = all + products.at(k);
        } else {
            all = apply(Add{}, all, products.at(k));
        }
    }
    return all;
}
[[nodiscard]] inline numeric::Interval sum(const std::array<numeric::Interval, most_components>& p,
                                           std::uint32_t count) {
    return numeric::sum_in_any_order(std::span(p).first(count));
}
[[nodiscard]] inline Explained sum(const std::array<Explained, most_components>& p, std::uint32_t count) {
    std::array<numeric::Interval, most_components> permitted{};
    Explained result = p[0];
    double reached = p[0].value;
    for (std::uint32_t k = 0; k < count; ++k) {
        permitted.at(k) = p.at(k).permitted;
        if (k == 0) continue;
        result.value = static_cast<float>(result.value) + static_cast<float>(p.at(k).value);
        result.exact += p.at(k).exact;
        reached += p.at(k).value;
    }
    result.permitted = sum(permitted, count);
    result.local = result.value - reached;
    return result;
}

template <class N>
[[nodiscard]] N dot(State<N>& s, const Instruction& i, Slot a, Slot b, std::uint32_t count,
                    std::uint32_t a_stride = 1, std::uint32_t b_stride = 1) {
    std::array<N, most_components> products{};
    for (std::uint32_t k = 0; k < count; ++k) {
        // The error of a product is a part of the sum's.
        const N x = s.number(i, a + k * a_stride);
        const N y = s.number(i, b + k * b_stride);
        products.at(k) = product(i, x, y);
        if (a == b && a_stride == b_stride) products.at(k) = as_square(products.at(k));
    }
    if constexpr (std::is_same_v<N, numeric::Rearranged>) {
        if ((i.flags & flags::no_contraction) != 0) {
            std::array<numeric::Interval, most_components> settled_products{};
            for (std::uint32_t k = 0; k < count; ++k) settled_products.at(k) = products.at(k).interval();
            return N(sum(settled_products, count));
        }
    }
    return sum(products, count);
}

// See Lowering::lower_matrix: count rows, sums of `extra` products, c columns.
template <class N>
void dot_product(State<N>& s, const Instruction& i) {
    s.set(i, i.result, of_finite(i, dot(s, i, i.a, i.b, i.extra)));
}

template <class N>
void matrix_times_matrix(State<N>& s, const Instruction& i) {
    for (std::uint32_t column = 0; column < i.c; ++column)
        for (std::uint32_t row = 0; row < i.count; ++row)
            s.set(i, i.result + column * i.count + row,
                  of_finite(i, dot(s, i, i.a + row, i.b + column * i.extra, i.extra, i.count)));
}

template <class N>
void vector_times_matrix(State<N>& s, const Instruction& i) {
    for (std::uint32_t column = 0; column < i.c; ++column)
        s.set(i, i.result + column, of_finite(i, dot(s, i, i.a, i.b + column * i.extra, i.extra)));
}

template <class N>
void outer_product(State<N>& s, const Instruction& i) {
    for (std::uint32_t column = 0; column < i.c; ++column)
        for (std::uint32_t row = 0; row < i.count; ++row)
            s.set(i, i.result + column * i.count + row,
                  of_finite(i, product(i, s.number(i, i.a + row), s.number(i, i.b + column))));
}

template <class N>
void length(State<N>& s, const Instruction& i) {
    s.set(i, i.result, of_finite(i, apply(Sqrt{}, dot(s, i, i.a, i.a, i.count))));
}

template <class N>
void distance(State<N>& s, const Instruction& i) {
    std::array<N, most_components> squares{};
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const N difference = apply(Subtract{}, s.number(i, i.a + k), s.number(i, i.b + k));
        squares.at(k) = as_square(apply(Multiply{}, difference, difference));
    }
    s.set(i, i.result, of_finite(i, apply(Sqrt{}, sum(squares, i.count))));
}

// Where a component is infinite, the others are open as well, though 1 by its root is 0.
template <class N>
void normalize(State<N>& s, const Instruction& i) {
    const N scale = numeric::Formula::step([&] {
        const N square = dot(s, i, i.a, i.a, i.count);
        return assumed(i, apply(InverseSqrt{}, square), square);
    });
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const N x = s.number(i, i.a + k);
        s.set(i, i.result + k, of_finite(i, apply(Multiply{}, x, scale)));
    }
}

template <class N>
void cross(State<N>& s, const Instruction& i) {
    for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t next = (k + 1) % 3;
        const std::uint32_t last = (k + 2) % 3;
        const N plus = product(i, s.number(i, i.a + next), s.number(i, i.b + last));
        const N minus = product(i, s.number(i, i.a + last), s.number(i, i.b + next));
        s.set(i, i.result + k, of_finite(i, contracted<Subtract>(i, plus, minus)));
    }
}

// I - 2 dot(N, I) N.
template <class N>
void reflect(State<N>& s, const Instruction& i) {
    const N twice = apply(Multiply{}, constant<N>(2.0), dot(s, i, i.b, i.a, i.count));
    for (std::uint32_t k = 0; k < i.count; ++k)
        s.set(i, i.result + k,
              of_finite(i, apply(Subtract{}, s.number(i, i.a + k),
                                 apply(Multiply{}, twice, s.number(i, i.b + k)))));
}

// k = 1 - eta^2 (1 - dot(N, I)^2); 0 where k < 0, else eta I - (eta dot(N, I) + sqrt(k)) N.
template <class N>
void refract(State<N>& s, const Instruction& i) {
    const N eta = s.number(i, i.c);
    const N cosine = dot(s, i, i.b, i.a, i.count);
    const N one = constant<N>(1.0);
    const N sine_squared = apply(Subtract{}, one, apply(Multiply{}, cosine, cosine));
    const N rest = apply(Subtract{}, one, apply(Multiply{}, apply(Multiply{}, eta, eta), sine_squared));
    const bool total = apply(Less{}, rest, constant<N>(0.0));
    const auto root = [&] { return apply(Sqrt{}, rest); };
    const N along = total ? one : apply(Add{}, apply(Multiply{}, eta, cosine), numeric::Formula::step(root));
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const N bent = apply(Subtract{}, apply(Multiply{}, eta, s.number(i, i.a + k)),
                             apply(Multiply{}, along, s.number(i, i.b + k)));
        s.set(i, i.result + k, of_finite(i, total ? constant<N>(0.0) : bent));
    }
}

// N where dot(Nref, I) < 0, else -N.
template <class N>
void face_forward(State<N>& s, const Instruction& i) {
    const N cosine = dot(s, i, i.c, i.b, i.count);
    const bool same = apply(Less{}, cosine, constant<N>(0.0));
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const N x = s.number(i, i.a + k);
        s.set(i, i.result + k, assumed(i, same ? x : apply(Negate{}, x), x, cosine));
    }
}

// Determinants and inverses. Vulkan leaves their precision to the implementation, so every result is
// permitted. On Explained the value is that of cofactors in float32, as drivers do it: where the condition of
// the matrix is bad, it is far from the exact one. float is rounded from double.

inline constexpr std::size_t most_elements = 16;
using Elements = std::array<double, most_elements>;

// The inverse, or the determinant alone.
template <class T, glm::length_t D>
[[nodiscard]] Elements calculated(const Elements& all, bool inverse) {
    glm::mat<D, D, T> m;
    for (glm::length_t k = 0; k < D * D; ++k)
        m[k / D][k % D] = static_cast<T>(all.at(static_cast<std::size_t>(k)));
    if (!inverse) return {static_cast<double>(glm::determinant(m))};
    m = glm::inverse(m);
    Elements result{};
    for (glm::length_t k = 0; k < D * D; ++k)
        result.at(static_cast<std::size_t>(k)) = static_cast<double>(m[k / D][k % D]);
    return result;
}
template <class T>
[[nodiscard]] Elements calculated(const Elements& all, std::uint32_t count, bool inverse) {
    return count == 4   ? calculated<T, 2>(all, inverse)
           : count == 9 ? calculated<T, 3>(all, inverse)
                        : calculated<T, 4>(all, inverse);
}

template <class N>
[[nodiscard]] double exact_of(const N& x) {
    if constexpr (std::is_same_v<N, Explained>) {
        return x.exact;
    } else if constexpr (has_bounds<N>) {
        const numeric::Interval any = permitted_of(x);
        return any.bounds().empty() ? std::numeric_limits<double>::quiet_NaN()
                                    : (any.low() + any.high()) / 2.0;
    } else {
        return x;
    }
}

// Any number; where gaps are closed, those between two results.
[[nodiscard]] inline numeric::Interval by_implementation(double x, double y) {
    if (!numeric::Paths::closes_gaps() || !std::isfinite(x) || !std::isfinite(y))
        return numeric::Interval::anything();
    return numeric::Interval::within(std::min(x, y), std::max(x, y));
}

template <class N>
void of_matrix(State<N>& s, const Instruction& i, bool inverse) {
    Elements operands{};
    Elements rounded{};
    for (std::uint32_t k = 0; k < i.count; ++k) {
        const N x = s.number(i, i.a + k);
        operands.at(k) = exact_of(x);
        if constexpr (std::is_same_v<N, Explained>) rounded.at(k) = x.value;
    }
    const Elements exact = calculated<double>(operands, i.count, inverse);
    const std::uint32_t results = inverse ? i.count : 1;
    if constexpr (std::is_same_v<N, Explained>) {
        const Elements values = calculated<float>(rounded, i.count, inverse);
        const Elements reached = calculated<double>(rounded, i.count, inverse);
        for (std::uint32_t k = 0; k < results; ++k)
            s.set(i, i.result + k,
                  N{.value = values.at(k),
                    .exact = exact.at(k),
                    .local = values.at(k) - reached.at(k),
                    .permitted = by_implementation(values.at(k), exact.at(k))});
    } else {
        for (std::uint32_t k = 0; k < results; ++k) {
            if constexpr (std::is_floating_point_v<N>)
                s.set(i, i.result + k, static_cast<N>(exact.at(k)));
            else
                s.set(i, i.result + k, N(by_implementation(exact.at(k), exact.at(k))));
        }
    }
}

}  // namespace gloam::interpreter::internal
