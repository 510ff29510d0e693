// SPDX-License-Identifier: MIT
#include "scene/internal/sobol.hpp"

namespace gloam::scene {
namespace {

constexpr std::uint32_t reversed(std::uint32_t x) {
    x = (x & 0x55555555U) << 1 | (x >> 1 & 0x55555555U);
    x = (x & 0x33333333U) << 2 | (x >> 2 & 0x33333333U);
    x = (x & 0x0f0f0f0fU) << 4 | (x >> 4 & 0x0f0f0f0fU);
    x = (x & 0x00ff00ffU) << 8 | (x >> 8 & 0x00ff00ffU);
    return x << 16 | x >> 16;
}

// The second coordinate. The first is the index with its bits reversed.
constexpr std::uint32_t sobol_second(std::uint32_t index) {
    std::uint32_t bits = 0;
    for (std::uint32_t direction = 1U << 31; index != 0; index >>= 1, direction ^= direction >> 1) {
        if ((index & 1U) != 0) bits ^= direction;
    }
    return bits;
}

// A hash flips each bit of x depending on the bits below it only. With the bits reversed this is a nested
// scrambling.
constexpr std::uint32_t laine_karras(std::uint32_t x, std::uint32_t seed) {
    x ^= x * 0x3d20adeaU;
    x += seed;
    x *= (seed >> 16) | 1U;
    x ^= x * 0x05526c56U;
    x ^= x * 0x53a22864U;
    return x;
}

double unit_open(std::uint32_t bits) {
    return (static_cast<double>(bits) + 0.5) * 0x1p-32;
}

}  // namespace

SobolPoints::SobolPoints(std::size_t count) {
    reversed_.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) reversed_.push_back({i, reversed(sobol_second(i))});
}

glm::dvec2 SobolPoints::scrambled(std::size_t index, std::uint64_t seed) const {
    const Bits bits = reversed_[index];
    const auto first = static_cast<std::uint32_t>(seed);
    const auto second = static_cast<std::uint32_t>(seed >> 32);
    return {unit_open(reversed(laine_karras(bits.x, first))),
            unit_open(reversed(laine_karras(bits.y, second)))};
}

}  // namespace gloam::scene
