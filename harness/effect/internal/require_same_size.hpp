// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <stdexcept>

namespace gloam::effect::internal {

// Throws std::invalid_argument that names the image, how many pixels it has and how many were expected.
inline void require_same_size(const char* what, std::size_t found, std::size_t expected) {
    if (found == expected) return;
    throw std::invalid_argument(fmt::format("{}: {} pixels, expected {}", what, found, expected));
}

}  // namespace gloam::effect::internal
