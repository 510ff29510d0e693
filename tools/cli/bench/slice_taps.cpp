// SPDX-License-Identifier: MIT
#include "cli/bench/slice_taps.hpp"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>

#include "cli/view_size.hpp"

namespace gloam::cli {

effect::SliceTaps slice_taps(const std::string& text) {
    constexpr std::uint32_t most = 64;
    const auto fits = [](std::uint32_t number) { return number >= 1 && number <= most; };
    const std::optional<gpu::Extent> pair = extent_from(text);
    if (pair && fits(pair->width) && fits(pair->height))
        return {.slices = pair->width, .steps = pair->height};
    throw std::invalid_argument(
        fmt::format("{}: expected SLICESxSTEPS, each 1 to {}, such as 9x3", text, most));
}

}  // namespace gloam::cli
