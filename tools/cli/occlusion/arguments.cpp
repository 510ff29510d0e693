// SPDX-License-Identifier: MIT
#include "cli/occlusion/arguments.hpp"

#include <fmt/format.h>
#include <charconv>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

namespace gloam::cli {

namespace {

// The two whole numbers of a text such as "640x360"; nothing for other text.
std::optional<std::pair<std::uint32_t, std::uint32_t>> pair_from(std::string_view text) {
    std::pair<std::uint32_t, std::uint32_t> pair;
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, pair.first);
    if (first.ec != std::errc{} || first.ptr == end || *first.ptr != 'x') return std::nullopt;
    const auto second = std::from_chars(first.ptr + 1, end, pair.second);
    if (second.ec != std::errc{} || second.ptr != end) return std::nullopt;
    return pair;
}

// sides: the allowed ones, in words.
gpu::Extent size_within(const std::string& text, std::uint32_t least, std::uint32_t most, const char* sides) {
    const auto fits = [&](std::uint32_t side) { return side >= least && side <= most; };
    const auto pair = pair_from(text);
    if (pair && fits(pair->first) && fits(pair->second)) return {pair->first, pair->second};
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
