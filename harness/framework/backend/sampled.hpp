// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "base/half.hpp"

// An image that a sampler reads, as words: a header, then the texels.
namespace gloam::backend {

// sampler2D, sampler2DArray, sampler3D, samplerCube, samplerCubeArray
enum class SampledShape : std::uint32_t { two, layers, three, cube, cube_layers };
// Floats of 16 bits; int; uint; floats of 32 bits in [0, 1], the first of four words, which a sampler
// compares.
enum class SampledTexel : std::uint32_t { real, integer, natural, depth };
enum class Wrap : std::uint32_t { repeat, mirrored, edge, border };  // of every coordinate; border: zeros
// Of the reference with a depth.
enum class Compare : std::uint32_t { less_equal, greater_equal, less, greater };

// What an interface calls a value of such an enumeration: `names` is in its order.
template <class Name, std::size_t count, class Value>
[[nodiscard]] constexpr Name named(const std::array<Name, count>& names, Value value) {
    return names.at(static_cast<std::size_t>(value));
}

struct SampledHeader {
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::uint32_t depth = 1;  // or layers; of cubes six layers each: +x, -x, +y, -y, +z, -z
    std::uint32_t levels = 1;
    SampledShape shape = SampledShape::two;
    SampledTexel texel = SampledTexel::real;
    std::uint32_t linear = 0;  // within a level and between levels; otherwise the nearest
    Wrap wrap = Wrap::repeat;
    Compare compare = Compare::less_equal;
};

[[nodiscard]] inline bool is_cube(SampledShape shape) {
    return shape == SampledShape::cube || shape == SampledShape::cube_layers;
}
inline constexpr std::uint32_t cube_faces = 6;

// Of a sampler's type in GLSL: "usampler3D", "sampler2DShadow".
[[nodiscard]] inline SampledTexel texel_of_sampler(std::string_view type) {
    if (type.ends_with("Shadow")) return SampledTexel::depth;
    if (type.starts_with('i')) return SampledTexel::integer;
    return type.starts_with('u') ? SampledTexel::natural : SampledTexel::real;
}
[[nodiscard]] inline SampledShape shape_of_sampler(std::string_view type) {
    if (type.ends_with("CubeArray")) return SampledShape::cube_layers;
    if (type.ends_with("Array")) return SampledShape::layers;
    if (type.ends_with("Cube")) return SampledShape::cube;
    return type.ends_with("3D") ? SampledShape::three : SampledShape::two;
}

inline constexpr std::size_t sampled_header_words = sizeof(SampledHeader) / sizeof(std::uint32_t);
inline constexpr std::size_t texel_words = 4;

// Width, height and depth of a level; layers stay.
[[nodiscard]] inline std::array<std::uint32_t, 3> size_of_level(const SampledHeader& image,
                                                                std::uint32_t level) {
    const auto side = [level](std::uint32_t size) { return std::max(size >> level, 1U); };
    return {side(image.width), side(image.height),
            image.shape == SampledShape::three ? side(image.depth) : image.depth};
}

// Texels of the levels before this one. Levels stand one after another, the largest first; the texels of a
// level row by row, layer by layer, four words each: the bits of floats or integers.
[[nodiscard]] inline std::size_t texels_before(const SampledHeader& image, std::uint32_t level) {
    std::size_t texels = 0;
    for (std::uint32_t l = 0; l < level; ++l) {
        const auto [width, height, depth] = size_of_level(image, l);
        texels += std::size_t{width} * height * depth;
    }
    return texels;
}

// The header of these words. Throws std::invalid_argument where the texels do not fit to it.
[[nodiscard]] inline SampledHeader sampled_header(std::span<const std::uint32_t> words) {
    SampledHeader header;
    if (words.size() >= sampled_header_words)
        std::memcpy(static_cast<void*>(&header), words.data(), sizeof header);
    if (words.size() != sampled_header_words + texels_before(header, header.levels) * texel_words)
        throw std::invalid_argument("a sampled image whose size and texels disagree");
    if (is_cube(header.shape) && (header.width != header.height || header.depth % cube_faces != 0))
        throw std::invalid_argument("an image of a cube that has not six square faces");
    return header;
}

// Words of a texel in an image of a device: floats of 16 bits, two in a word; one depth.
[[nodiscard]] inline std::size_t stored_words(SampledTexel texel) {
    return texel == SampledTexel::depth ? 1 : texel == SampledTexel::real ? texel_words / 2 : texel_words;
}

// The texels of these words, which begin with a header, as such an image has them.
[[nodiscard]] inline std::vector<std::uint32_t> stored_texels(std::span<const std::uint32_t> words) {
    const SampledTexel texel = sampled_header(words).texel;
    const auto texels = words.subspan(sampled_header_words);
    const std::size_t step = texel_words / stored_words(texel);
    std::vector<std::uint32_t> stored;
    for (std::size_t i = 0; i < texels.size(); i += step) {
        const auto half = [&](std::size_t at) {
            return std::uint32_t{base::to_half(std::bit_cast<float>(texels[at]))};
        };
        stored.push_back(texel == SampledTexel::real ? half(i + 1) << 16U | half(i) : texels[i]);
    }
    return stored;
}

}  // namespace gloam::backend
