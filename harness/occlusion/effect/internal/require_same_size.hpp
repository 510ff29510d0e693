// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <stdexcept>

namespace gloam::effect::internal {

// Throws std::invalid_argument if `found` is not `expected`; the message holds both counts of pixels and
// `what`, the name of the image.
inline void require_same_size(const char* what, std::size_t found, std::size_t expected) {
    if (found == expected) return;
    throw std::invalid_argument(fmt::format("{}: {} pixels, expected {}", what, found, expected));
}

}  // namespace gloam::effect::internal
