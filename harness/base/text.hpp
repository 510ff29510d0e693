// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace gloam::base {

// The text, or as much of its beginning as fits into `most` bytes with "..." behind it; no character of UTF-8
// is cut in two. For what a message quotes.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most);

// The text in one line that a terminal shows as it is: what is no character, a line break say, is a space.
[[nodiscard]] std::string one_line(std::string_view text);

// Whether a text is a name of at most 1000 bytes in one line, without control characters, and not empty.
[[nodiscard]] bool is_name(std::string_view text);

// A name for a file from any text: letters, digits, '-', '_' and '.' stay (a dot not in front), other bytes
// become %XX. Two texts have two names, up to 100 bytes; what is longer ends in a hash.
[[nodiscard]] std::string file_name_of(std::string_view text);

}  // namespace gloam::base
