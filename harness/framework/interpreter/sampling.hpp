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
    // With which precision a driver may calculate weights (DeviceInfo).
    std::uint32_t subtexel_bits = 4;
    std::uint32_t level_bits = 4;
    double largest = 0.0;  // magnitude of a float of the texels

    // The index of the first word of a texel: x, y, and z or the layer.
    [[nodiscard]] std::size_t word_of(std::uint32_t level, const std::array<std::uint32_t, 3>& texel) const;
};

// The view of the words of backend/sampled.hpp. Throws std::invalid_argument where they disagree.
[[nodiscard]] SampledView sampled_view_of(std::span<const backend::Word> words, std::uint32_t subtexel_bits,
                                          std::uint32_t level_bits);

// Where a sampler reads, as bounds.
struct SamplePoint {
    std::array<numeric::Bounds, 3> at{};  // coordinates, the layer last
    numeric::Bounds level = numeric::Bounds::point(0.0);
    std::array<int, 3> offset{};  // in texels
    int component = -1;           // of a gather: whose four texels are the result; -1: no gather
};

// Whether a point has a place in or around the image.
[[nodiscard]] bool has_place(const SampledView& image, const SamplePoint& point);

// exact: of a point, in real numbers. permitted: all that a driver may return. Weights may be fixed-point
// numbers with the bits of the view. Coordinates in texels may be wrong by the last of these bits, and by
// 2^-22 of themselves. Filtered floats may have the precision of 16 bits. A coordinate or level that is NaN
// permits everything, and so does one beyond the integers of 32 bits, or a gradient whose square is no float.
enum class Precision { exact, permitted };

// The four components, of an image of floats.
[[nodiscard]] std::array<numeric::Bounds, 4> sampled(const SampledView& image, const SamplePoint& point,
                                                     Precision precision);

// All texels that may be the result, for an image of integers: each the index of its first word, or `outside`
// for the border. A gather's are those of the first of its four; `step` has the positions of the four.
inline constexpr std::size_t outside = static_cast<std::size_t>(-1);
[[nodiscard]] std::vector<std::array<std::size_t, 4>> sampled_texels(const SampledView& image,
                                                                     const SamplePoint& point,
                                                                     Precision precision);

// The levels that gradients select: the base-2 logarithm of a length in texels. A driver may approximate
// both.
[[nodiscard]] numeric::Bounds level_of(const SampledView& image, std::span<const numeric::Bounds> dx,
                                       std::span<const numeric::Bounds> dy, Precision precision);

}  // namespace gloam::interpreter
