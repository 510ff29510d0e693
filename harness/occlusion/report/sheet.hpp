// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gloam::report {

// A picture of a sheet, and the line below it.
struct SheetPicture {
    std::vector<std::uint8_t> rgb;  // sRGB, three bytes for each pixel, rows from the top
    std::string caption;            // ASCII and Latin-1; cut at the picture's width
};

// PNG of pictures of one size on light grey, `columns` in a row, each with its caption below. There are no
// captions if the font DejaVu Sans is not installed. Throws std::invalid_argument for no pictures, no
// columns, and a picture of another size.
[[nodiscard]] std::string to_sheet_png(std::span<const SheetPicture> pictures, std::uint32_t width,
                                       std::uint32_t height, std::size_t columns);

}  // namespace gloam::report
