// SPDX-License-Identifier: MIT
#include "cli/bench/image_size.hpp"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "cli/arguments.hpp"

namespace gloam::cli {

gpu::Extent image_size(const std::string& text) {
    constexpr std::uint32_t smallest = 16;
    constexpr std::uint32_t largest = 4096;
    const auto fits = [](std::uint32_t side) { return side >= smallest && side <= largest; };
    const std::optional<gpu::Extent> extent = extent_from(text);
    if (extent && fits(extent->width) && fits(extent->height)) return *extent;
    throw std::invalid_argument(
        fmt::format("--size {}: expected WIDTHxHEIGHT in pixels, each {} to {}, such as 192x108", text,
                    smallest, largest));
}

}  // namespace gloam::cli
