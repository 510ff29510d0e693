// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/image_files.hpp"

namespace gloam::pictures {

// Visibility, 1 - occlusion, in grey: see to_visibility_png().
[[nodiscard]] base::RgbBytes visibility_rgb(std::span<const float> occlusion);

// PNG of visibility, 1 - occlusion, white where open, for display. Occlusion is clamped to [0, 1]; NaN counts
// as 0. Linear: value v in [0, 1] is stored as v * 255, rounded to the nearest.
[[nodiscard]] std::string to_visibility_png(std::span<const float> occlusion, std::uint32_t width,
                                            std::uint32_t height);

// A picture of a sheet, and the line below it.
struct SheetPicture {
    std::vector<std::uint8_t> rgb;  // sRGB, three bytes for each pixel, rows from the top
    std::string caption;            // ASCII and Latin-1; up to three lines of the picture's width
};

// PNG of pictures of one size on light grey, `columns` in a row, each with its caption below. There are no
// captions if the font DejaVu Sans is not installed. At least one picture and one column.
[[nodiscard]] std::string to_sheet_png(std::span<const SheetPicture> pictures, std::uint32_t width,
                                       std::uint32_t height, std::size_t columns);

}  // namespace gloam::pictures
