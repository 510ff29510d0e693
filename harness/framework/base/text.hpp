// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace gloam::base {

// The text, or its beginning followed by "...", in at most `most` bytes. No UTF-8 character is cut. For
// quotes in messages.
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most);

// The text without control characters other than line breaks and tabs, and without bytes that are no UTF-8:
// each becomes spaces. A text from elsewhere could otherwise change the terminal that it is printed on.
[[nodiscard]] std::string for_terminal(std::string_view text);

// The text in one line for a terminal: every character that is not printable, for example a line break,
// becomes a space.
[[nodiscard]] std::string one_line(std::string_view text);

// The text with small ASCII letters.
[[nodiscard]] std::string lower(std::string text);

// The text with other words wherever `from` stands, which is not empty.
[[nodiscard]] std::string replaced(std::string text, std::string_view from, std::string_view to);

// Whether a text is a name of at most 1000 bytes in one line, without control characters, and not empty.
[[nodiscard]] bool is_name(std::string_view text);

// A file name from any text: letters, digits, '-', '_' and '.' are kept (except a leading dot), other bytes
// become %XX. Different texts have different names, up to 100 bytes; a longer name ends in a hash.
[[nodiscard]] std::string file_name_of(std::string_view text);

// Bytes as base64 (RFC 4648, section 4), with padding.
[[nodiscard]] std::string base64(std::span<const unsigned char> bytes);

// Bounds of a JSON text for parsers, which recurse into nested values, and search each name of an object
// among the names before it: 64 MiB, 64 arrays and objects within each other, 1000 members of one object.
// Throws std::runtime_error with the bound that a text exceeds, and the line. It does not test whether the
// text is valid JSON; a parser finds no deeper nesting than this function.
void require_bounded_json(std::string_view text);

}  // namespace gloam::base
