// SPDX-License-Identifier: MIT
#include "cli/view_size.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

namespace gloam::cli {

gpu::Extent parse_size(const std::string& text) {
    gpu::Extent extent;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, extent.width);
    bool good = width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x';
    if (good) {
        const auto height = std::from_chars(width.ptr + 1, end, extent.height);
        good = height.ec == std::errc{} && height.ptr == end;
    }
    if (good && extent.width > 0 && extent.height > 0) return extent;
    throw std::invalid_argument(
        fmt::format("--size {}: expected WIDTHxHEIGHT in pixels, each 1 or more, such as 640x360", text));
}

}  // namespace gloam::cli
