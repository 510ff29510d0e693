// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace gloam::base {

// Bounds of a JSON text for parsers. Parsers recurse into nested values, and search each name of an object
// among the names before it.
struct JsonBounds {
    std::size_t bytes = std::size_t{64} << 20;
    std::size_t depth = 64;      // arrays and objects within each other
    std::size_t members = 1000;  // of one object
};

// Throws std::runtime_error with the bound that a text exceeds, and the line. It does not test whether the
// text is valid JSON; a parser finds no deeper nesting than this function.
void require_bounded_json(std::string_view text, const JsonBounds& bounds = {});

}  // namespace gloam::base
