// SPDX-License-Identifier: MIT
#include "effect/study/expectation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gloam::effect {
namespace {

constexpr std::size_t shifts = 8;
constexpr std::uint32_t fewest = 1U << 11U;
constexpr std::uint32_t most = 1U << 17U;

// Powers of 1 / 1.2207440846, the root of x^4 = x + 1: the additive recurrence with the most even
// distribution in three dimensions.
constexpr std::array<double, 3> generator{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};

// Evenly distributed shifts, by the golden ratio and related numbers; as good as random ones.
std::array<double, 3> shift_of(std::size_t number) {
    const double n = static_cast<double>(number) + 0.5;
    return {n * 0.6180339887498949, n * 0.7548776662466927, n * 0.4142135623730951};
}

double fraction(double x) {
    return x - std::floor(x);
}

// The sum over the points `from` to `to` (excluded) of a shifted lattice.
glm::dvec2 sum_of(const Integrand& integrand, const std::array<double, 3>& shift, std::uint32_t from,
                  std::uint32_t to) {
    glm::dvec2 sum(0.0);
    for (std::uint32_t i = from; i < to; ++i) {
        std::array<double, 3> point{};
        for (std::size_t k = 0; k < 3; ++k)
            point.at(k) = fraction(shift.at(k) + generator.at(k) * static_cast<double>(i));
        sum += integrand(point);
    }
    return sum;
}

double mean_of(const glm::dvec2& sum) {
    return sum.y > 0.0 ? std::clamp(sum.x / sum.y, 0.0, 1.0) : 0.0;
}

Estimate summary(const std::array<glm::dvec2, shifts>& sums) {
    glm::dvec2 total(0.0);
    double mean = 0.0;
    for (const glm::dvec2& sum : sums) {
        total += sum;
        mean += mean_of(sum) / shifts;
    }
    double squares = 0.0;
    for (const glm::dvec2& sum : sums) squares += std::pow(mean_of(sum) - mean, 2.0);
    return {mean_of(total), std::sqrt(squares / (shifts * (shifts - 1.0)))};
}

}  // namespace

Estimate expectation(const Integrand& integrand, double tolerance) {
    std::array<glm::dvec2, shifts> sums{};
    std::uint32_t taken = 0;
    for (std::uint32_t count = fewest; count <= most; count *= 2) {
        for (std::size_t s = 0; s < shifts; ++s) sums.at(s) += sum_of(integrand, shift_of(s), taken, count);
        taken = count;
        if (const Estimate found = summary(sums); found.error <= tolerance) return found;
    }
    return summary(sums);
}

}  // namespace gloam::effect
