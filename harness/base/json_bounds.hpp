// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>

namespace gloam::base {

// How much a JSON text may demand of whoever parses it: parsers recurse into what is nested, and look each
// name of an object up among those before it.
struct JsonBounds {
    std::size_t bytes = std::size_t{64} << 20;
    std::size_t depth = 64;      // arrays and objects within each other
    std::size_t members = 1000;  // of one object
};

// Throws std::runtime_error that says which bound a text exceeds, and in which line. Whether it is JSON is
// for the parser to say; it finds nothing more deeply nested than this has seen.
void require_bounded_json(std::string_view text, const JsonBounds& bounds = {});

}  // namespace gloam::base
