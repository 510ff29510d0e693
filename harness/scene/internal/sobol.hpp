// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace gloam::scene {

// Well-mixed bits of a number, the same on every machine (the finaliser of SplitMix64).
[[nodiscard]] constexpr std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
    return x ^ (x >> 31);
}

// The first points of the two-dimensional Sobol' sequence, with a new scrambling for each use.
class SobolPoints {
  public:
    explicit SobolPoints(std::size_t count);

    [[nodiscard]] std::size_t size() const { return reversed_.size(); }

    // Point `index` in (0, 1)^2 with the scrambling `seed`. Scramblings of different seeds are independent,
    // each point is uniform, and the points of one seed keep the strata of the sequence: nested uniform
    // scrambling (Owen), with the hash of Laine and Karras.
    [[nodiscard]] glm::dvec2 scrambled(std::size_t index, std::uint64_t seed) const;

  private:
    struct Bits {
        std::uint32_t x;
        std::uint32_t y;
    };
    std::vector<Bits> reversed_;  // the coordinates' 32 bits, least significant first
};

}  // namespace gloam::scene
