// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace gloam::base {

// A float image, rows from the top, `channels` floats for each pixel.
struct FloatImage {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    int channels = 1;
    std::vector<float> texels;
};

// Reads a portable float map (Pf or PF, either byte order). Throws std::runtime_error with the file's name if
// it is missing, not a PFM, truncated, or longer than its header says.
[[nodiscard]] FloatImage read_pfm(const std::filesystem::path& file);

// sRGB of 8 bits, three bytes for each pixel, as to_png() takes them.
using RgbBytes = std::vector<std::uint8_t>;

// Magnitudes of errors as a heat map: 0 is nearly black, then come violet and red; `full` (> 0) and more is
// pale yellow. Lightness rises evenly (in Oklab), so that the order of values is visible in grey as well.
// NaN, an unknown error, is grey. Throws std::invalid_argument for a scale not > 0.
[[nodiscard]] RgbBytes heat_rgb(std::span<const float> errors, double full);

// Linear red, green and blue in [0, 1], three for each pixel, as sRGB (IEC 61966-2-1). Values are clamped to
// [0, 1]; NaN counts as 0.
[[nodiscard]] RgbBytes srgb_of(std::span<const float> linear);

// Images as the bytes of a file. `width` and `height` in pixels, rows from the top. All throw
// std::invalid_argument when the number of texels does not match the size.

// Portable float map, little-endian: width * height * channels floats, 1 or 3 channels. Any float is kept,
// bit by bit.
[[nodiscard]] std::string to_pfm(std::span<const float> texels, std::uint32_t width, std::uint32_t height,
                                 int channels);

// PNG of 8 bits: red, green and blue of each pixel, or (1 channel) grey.
[[nodiscard]] std::string to_png(std::span<const std::uint8_t> texels, std::uint32_t width,
                                 std::uint32_t height, int channels = 3);

// Bytes compressed in the zlib format (RFC 1950), as base64; nothing of no bytes.
[[nodiscard]] std::string deflated_base64(std::span<const unsigned char> bytes);

}  // namespace gloam::base
