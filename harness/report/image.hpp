// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace gloam::report {

// Images as the bytes of a file. `width` and `height` in pixels, rows from the top; all throw
// std::invalid_argument when the number of texels is not what the size asks for.

// Portable float map, little-endian: width * height * channels floats, 1 or 3 channels. Any float is kept,
// bit by bit.
[[nodiscard]] std::string to_pfm(std::span<const float> texels, std::uint32_t width, std::uint32_t height,
                                 int channels);

// PNG of 8-bit grey.
[[nodiscard]] std::string to_png(std::span<const std::uint8_t> grey, std::uint32_t width,
                                 std::uint32_t height);

// PNG of visibility, 1 - occlusion, white where open: what one looks at. Occlusion outside [0, 1] is taken to
// the nearer end, NaN to 0. Linear: value v in [0, 1] is stored as v * 255, rounded to the nearest.
[[nodiscard]] std::string to_visibility_png(std::span<const float> occlusion, std::uint32_t width,
                                            std::uint32_t height);

// PNG of 8-bit red, green and blue, three bytes for each pixel.
[[nodiscard]] std::string to_rgb_png(std::span<const std::uint8_t> rgb, std::uint32_t width,
                                     std::uint32_t height);

// PNG of the magnitudes of errors as a heat map: 0 nearly black, `full` (> 0) and more pale yellow, in the
// colours of heat_color(); grey where the error is NaN, which is to say not known.
[[nodiscard]] std::string to_heat_png(std::span<const float> errors, std::uint32_t width,
                                      std::uint32_t height, double full);

}  // namespace gloam::report
