// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "interpreter/sampling.hpp"

// Texels of one level of an image, and how a filter mixes them.
namespace gloam::interpreter::internal {

inline constexpr double relative_error = 0x1p-22;  // of a coordinate in texels
inline constexpr double smallest_normal = 0x1p-126;
inline constexpr numeric::Bounds nothing{std::numeric_limits<double>::infinity(),
                                         -std::numeric_limits<double>::infinity(), false};

// A texel of one axis, and the weight of the texel behind it.
struct Choice {
    long texel;
    numeric::Bounds weight;
};

// The ends of what a texel may be.
enum class End { low, high };

[[nodiscard]] inline numeric::Bounds widened(const numeric::Bounds& x, double absolute, double relative) {
    return {x.low - absolute - std::abs(x.low) * relative, x.high + absolute + std::abs(x.high) * relative,
            x.nan};
}

[[nodiscard]] inline bool is_finite(const numeric::Bounds& x) {
    return !x.nan && !x.empty() && std::isfinite(x.low) && std::isfinite(x.high);
}

[[nodiscard]] inline double mixed(double a, double b, double weight) {
    return weight == 0.0 ? a : weight == 1.0 ? b : a + (b - a) * weight;
}

// Axes that are filtered; the last coordinate of layers is not.
[[nodiscard]] std::size_t axes_of(const backend::SampledHeader& header);

// The nearest layers, a half to either side.
[[nodiscard]] std::vector<std::uint32_t> layers_at(const numeric::Bounds& at, std::uint32_t layers);

// One level of an image, and what may be read of it. `footprint`: of a filter or a gather, with the texels
// behind the nearest. A point of a cube has coordinates on a face and the layer of the image.
class Level {
  public:
    Level(const SampledView& image, std::uint32_t level, const SamplePoint& point, Precision precision,
          bool footprint);

    // Calls visit(x, y, z) for every combination of choices.
    template <class Visit>
    void for_each(Visit visit) const {
        for (const Choice& z : axes_[2])
            for (const Choice& y : axes_[1])
                for (const Choice& x : axes_[0]) visit(x, y, z);
    }

    // The first word of a texel; `outside` for the border; nullopt beyond the corner of a cube.
    [[nodiscard]] std::optional<std::size_t> word(long x, long y, long z) const;

    // One end of what the texel may be.
    [[nodiscard]] double value(long x, long y, long z, std::size_t component, End end) const;

    // Whether a texel may have several values.
    [[nodiscard]] bool has_ends() const {
        return image_.header.texel == backend::SampledTexel::depth || is_cube(image_.header.shape);
    }

  private:
    [[nodiscard]] std::size_t word_inside(const std::array<long, 3>& at) const;
    [[nodiscard]] double value_of(std::size_t first, std::size_t component, End end) const;

    const SampledView& image_;
    numeric::Bounds reference_;
    Precision precision_;
    bool footprint_;
    std::size_t first_;  // texel of the level
    std::array<std::uint32_t, 3> size_;
    std::array<std::vector<Choice>, 3> axes_;
};

[[nodiscard]] std::array<numeric::Bounds, 4> filtered_level(const Level& level);

// In the order of textureGather: (0, 1), (1, 1), (1, 0), (0, 0).
inline constexpr std::array<std::array<long, 2>, 4> gathered{{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};

[[nodiscard]] std::array<numeric::Bounds, 4> gathered_level(const Level& level, std::size_t component);

}  // namespace gloam::interpreter::internal
