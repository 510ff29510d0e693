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
    std::string caption;            // ASCII and Latin-1; what does not fit the picture's width is cut
};

// PNG of pictures of one size, `columns` in a row, each with its caption below, on light grey. The captions
// are left out on a machine without the font DejaVu Sans. Throws std::invalid_argument for no pictures, no
// columns, and a picture of another size.
[[nodiscard]] std::string to_sheet_png(std::span<const SheetPicture> pictures, std::uint32_t width,
                                       std::uint32_t height, std::size_t columns);

}  // namespace gloam::report
