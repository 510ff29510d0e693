// SPDX-License-Identifier: MIT
#include "base/json_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace gloam::base {
namespace {

// The end of a string that begins at `at` with its quote: behind the quote that ends it.
std::size_t end_of_string(std::string_view text, std::size_t at) {
    for (++at; at < text.size() && text[at] != '"'; ++at)
        if (text[at] == '\\') ++at;
    return at + 1;
}

[[noreturn]] void exceed(std::string_view text, std::size_t at, const std::string& what) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    throw std::runtime_error(fmt::format("line {}: {}", line, what));
}

}  // namespace

void require_bounded_json(std::string_view text, const JsonBounds& bounds) {
    if (text.size() > bounds.bytes)
        throw std::runtime_error(
            fmt::format("{} bytes of JSON, expected at most {}", text.size(), bounds.bytes));
    std::vector<std::size_t> names;  // colons seen, in each array or object that is open
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"') {
            at = end_of_string(text, at) - 1;
        } else if (c == '[' || c == '{') {
            if (names.size() == bounds.depth)
                exceed(text, at, fmt::format("nested more than {} deep", bounds.depth));
            names.push_back(0);
        } else if ((c == ']' || c == '}') && !names.empty()) {
            names.pop_back();
        } else if (c == ':' && !names.empty() && ++names.back() > bounds.members) {
            exceed(text, at, fmt::format("an object of more than {} members", bounds.members));
        }
    }
}

}  // namespace gloam::base
