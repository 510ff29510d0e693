// SPDX-License-Identifier: MIT
#include "cli/bench/image_size.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

namespace gloam::cli {

gpu::Extent image_size(const std::string& text) {
    constexpr std::uint32_t smallest = 16;
    constexpr std::uint32_t largest = 4096;
    gpu::Extent extent;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, extent.width);
    if (width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, extent.height);
        if (height.ec == std::errc{} && height.ptr == end && extent.width >= smallest &&
            extent.height >= smallest && extent.width <= largest && extent.height <= largest)
            return extent;
    }
    throw std::invalid_argument(
        fmt::format("--size {}: expected WIDTHxHEIGHT in pixels, each {} to {}, such as 192x108", text,
                    smallest, largest));
}

}  // namespace gloam::cli
