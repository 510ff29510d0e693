// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/matrix.hpp>

#include "interpreter/internal/vectors.hpp"

// Determinants and inverses. Vulkan leaves their precision to the implementation, so every result is
// permitted; float is rounded from double.
namespace gloam::interpreter::internal {

[[nodiscard]] inline double as_double(float x) {
    return x;
}
[[nodiscard]] inline double as_double(double x) {
    return x;
}
[[nodiscard]] inline double as_double(const Explained& x) {
    return x.exact;
}

template <class N>
[[nodiscard]] N implementation_defined(double exact) {
    if constexpr (std::is_floating_point_v<N>) {
        return static_cast<N>(exact);
    } else if constexpr (std::is_same_v<N, Explained>) {
        return {.value = static_cast<float>(exact),
                .exact = exact,
                .local = 0.0,
                .permitted = numeric::Interval::anything()};
    } else {
        return undefined_number<N>();
    }
}

inline constexpr std::size_t most_elements = 16;

template <class N>
[[nodiscard]] std::array<double, most_elements> elements(State<N>& s, const Instruction& i) {
    std::array<double, most_elements> all{};
    if constexpr (!std::is_same_v<N, numeric::Interval> && !std::is_same_v<N, numeric::Rearranged>) {
        for (std::uint32_t k = 0; k < i.count; ++k) all.at(k) = as_double(s.number(i, i.a + k));
    }
    return all;
}

template <glm::length_t D>
[[nodiscard]] glm::mat<D, D, double> matrix_of(const std::array<double, most_elements>& all) {
    glm::mat<D, D, double> m;
    for (glm::length_t k = 0; k < D * D; ++k) m[k / D][k % D] = all.at(static_cast<std::size_t>(k));
    return m;
}

[[nodiscard]] inline double determinant_of(const std::array<double, most_elements>& all,
                                           std::uint32_t count) {
    switch (count) {
        case 4:
            return glm::determinant(matrix_of<2>(all));
        case 9:
            return glm::determinant(matrix_of<3>(all));
        default:
            return glm::determinant(matrix_of<4>(all));
    }
}

template <glm::length_t D>
[[nodiscard]] std::array<double, most_elements> inverse_of(const std::array<double, most_elements>& all) {
    const glm::mat<D, D, double> m = glm::inverse(matrix_of<D>(all));
    std::array<double, most_elements> result{};
    for (glm::length_t k = 0; k < D * D; ++k) result.at(static_cast<std::size_t>(k)) = m[k / D][k % D];
    return result;
}

template <class N>
void determinant(State<N>& s, const Instruction& i) {
    s.set(i, i.result, implementation_defined<N>(determinant_of(elements(s, i), i.count)));
}

template <class N>
void inverse(State<N>& s, const Instruction& i) {
    const std::array<double, most_elements> m = elements(s, i);
    const std::array<double, most_elements> result =
        i.count == 4 ? inverse_of<2>(m) : (i.count == 9 ? inverse_of<3>(m) : inverse_of<4>(m));
    for (std::uint32_t k = 0; k < i.count; ++k)
        s.set(i, i.result + k, implementation_defined<N>(result.at(k)));
}

template <class N>
[[nodiscard]] Handler<N> matrix_handler(std::uint16_t opcode) {
    switch (opcode) {
        case extended + GLSLstd450Determinant:
            return determinant<N>;
        case extended + GLSLstd450MatrixInverse:
            return inverse<N>;
        default:
            return nullptr;
    }
}

}  // namespace gloam::interpreter::internal
