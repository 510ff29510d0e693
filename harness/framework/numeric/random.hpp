// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <string_view>

namespace gloam::numeric {

// Seeded random numbers, the same on every machine (the standard's distributions, which take this generator,
// are not).
class Random {
  public:
    using result_type = std::uint64_t;
    static constexpr result_type min() { return 0; }
    static constexpr result_type max() { return ~result_type{0}; }
    result_type operator()() { return engine_(); }

    explicit Random(std::uint64_t seed) : engine_(seed) {}

    // Uniform in [0, 1) with 53 random bits.
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double uniform(double low, double high) { return low + (high - low) * unit(); }
    // Uniform in 0 ... count - 1; count > 0 and far below 2^64.
    std::uint64_t below(std::uint64_t count) { return engine_() % count; }

  private:
    std::mt19937_64 engine_;
};

// FNV-1a: a seed from a name, the same on every machine.
[[nodiscard]] constexpr std::uint64_t hash_of(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
    return hash;
}

}  // namespace gloam::numeric
