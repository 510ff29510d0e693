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

namespace {

// The two integers of "640x360"; nothing for other text.
std::optional<gpu::Extent> extent_from(std::string_view text) {
    gpu::Extent extent;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, extent.width);
    if (width.ec != std::errc{} || width.ptr == end || *width.ptr != 'x') return std::nullopt;
    const auto height = std::from_chars(width.ptr + 1, end, extent.height);
    if (height.ec != std::errc{} || height.ptr != end) return std::nullopt;
    return extent;
}

// sides: the allowed ones, in words.
gpu::Extent size_within(const std::string& text, std::uint32_t least, std::uint32_t most, const char* sides) {
    const auto fits = [&](std::uint32_t side) { return side >= least && side <= most; };
    const std::optional<gpu::Extent> extent = extent_from(text);
    if (extent && fits(extent->width) && fits(extent->height)) return *extent;
    throw std::invalid_argument(
        fmt::format("--size {}: expected WIDTHxHEIGHT in pixels, each {}, such as 640x360", text, sides));
}

}  // namespace

gpu::Extent parse_size(const std::string& text) {
    return size_within(text, 1, std::numeric_limits<std::uint32_t>::max(), "1 or more");
}

gpu::Extent judged_size(const std::string& text) {
    return size_within(text, 16, 4096, "16 to 4096");
}

}  // namespace gloam::cli
