// SPDX-License-Identifier: MIT
#include "cli/arguments.hpp"

#include <fmt/format.h>
#include <charconv>
#include <stdexcept>

#include "base/files.hpp"

namespace gloam::cli {

std::string read_text(const std::filesystem::path& file) {
    return base::read_file(file);
}

std::optional<gpu::Extent> extent_from(std::string_view text) {
    gpu::Extent extent;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, extent.width);
    if (width.ec != std::errc{} || width.ptr == end || *width.ptr != 'x') return std::nullopt;
    const auto height = std::from_chars(width.ptr + 1, end, extent.height);
    if (height.ec != std::errc{} || height.ptr != end) return std::nullopt;
    return extent;
}

gpu::Extent parse_size(const std::string& text) {
    const std::optional<gpu::Extent> extent = extent_from(text);
    if (extent && extent->width > 0 && extent->height > 0) return *extent;
    throw std::invalid_argument(
        fmt::format("--size {}: expected WIDTHxHEIGHT in pixels, each 1 or more, such as 640x360", text));
}

}  // namespace gloam::cli
