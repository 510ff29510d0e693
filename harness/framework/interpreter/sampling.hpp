// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "backend/backend.hpp"
#include "backend/sampled.hpp"
#include "numeric/interval.hpp"

// What a sampler may return (the chapter "Image Operations" of the Vulkan specification).
namespace gloam::interpreter {

// An image with its sampler.
struct SampledView {
    backend::SampledHeader header;
    std::span<const backend::Word> texels;
    backend::SamplerPrecision precision;  // with which a driver may calculate
    double largest = 0.0;                 // magnitude of a float of the texels

    // The index of the first word of a texel: x, y, and z or the layer.
    [[nodiscard]] std::size_t word_of(std::uint32_t level, const std::array<std::uint32_t, 3>& texel) const;
};

// The view of the words of backend/sampled.hpp. Throws std::invalid_argument where they disagree.
[[nodiscard]] SampledView sampled_view_of(std::span<const backend::Word> words,
                                          const backend::SamplerPrecision& precision);

// Where a sampler reads, as bounds.
struct SamplePoint {
    std::array<numeric::Bounds, 4> at{};  // coordinates, the layer behind them; of a cube a direction
    numeric::Bounds level = numeric::Bounds::point(0.0);
    std::array<int, 3> offset{};  // in texels
    int component = -1;           // of a gather: whose four texels are the result; -1: no gather
    numeric::Bounds reference = numeric::Bounds::point(0.0);  // with which depths are compared
};

// Whether a point has a place in or around the image.
[[nodiscard]] bool has_place(const SampledView& image, const SamplePoint& point);

// exact: of a point, in real numbers. permitted: all that a driver may return. Weights may be fixed-point
// numbers with the bits of the view. Coordinates in texels may be wrong by the last of these bits, and by
// 2^-22 of themselves. Filtered floats may have the precision of 16 bits. A coordinate or level that is NaN
// permits everything, and so does one beyond the integers of 32 bits, or a gradient whose square is no float.
enum class Precision { exact, permitted };

// The four components, of an image of floats. Of depths, the first is the result of the comparison, 1 where
// it holds; each texel is compared before the filter. Beyond the corner of a cube is the mean of the three
// texels there; a driver may return anything between them.
[[nodiscard]] std::array<numeric::Bounds, 4> sampled(const SampledView& image, const SamplePoint& point,
                                                     Precision precision);

// All texels that may be the result, for an image of integers: each the index of its first word, or `outside`
// for the border. A gather has four. None: beyond the corner of a cube, where every value is permitted.
inline constexpr std::size_t outside = static_cast<std::size_t>(-1);
[[nodiscard]] std::vector<std::array<std::size_t, 4>> sampled_texels(const SampledView& image,
                                                                     const SamplePoint& point,
                                                                     Precision precision);

// How the coordinates change along x and along y.
struct Gradients {
    std::array<numeric::Bounds, 3> dx{};
    std::array<numeric::Bounds, 3> dy{};
    bool of_neighbours = false;  // differences in a quad
};

// The levels that gradients at a point select: the base-2 logarithm of a length in texels. A driver may
// approximate both.
[[nodiscard]] numeric::Bounds level_of(const SampledView& image, const SamplePoint& point,
                                       const Gradients& gradients, Precision precision);

}  // namespace gloam::interpreter
