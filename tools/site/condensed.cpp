// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string>
#include <string_view>

#include "site/page_data.hpp"

namespace gloam::site {

namespace {

// Position behind the comment that begins at `at`, or `at` where none does. The end of a line comment is its
// line's end.
std::size_t behind_comment(std::string_view text, std::size_t at) {
    const std::string_view begin = text.substr(at, 2);
    if (begin == "//") return std::min(text.find('\n', at), text.size());
    if (begin != "/*") return at;
    const std::size_t end = text.find("*/", at + 2);
    return end == std::string_view::npos ? text.size() : end + 2;
}

// A line without the blanks at its ends.
std::string_view without_ends(std::string_view line) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t first = line.find_first_not_of(blanks);
    if (first == std::string_view::npos) return {};
    return line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

}  // namespace

std::string condensed(std::string_view text) {
    std::string code;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t behind = behind_comment(text, at);
        code += behind == at ? text[at] : ' ';
        at = behind == at ? at + 1 : behind;
    }
    const bool macros = code.find("#define") != std::string::npos;
    std::string lines;
    for (std::size_t at = 0; at < code.size();) {
        const std::size_t end = std::min(code.find('\n', at), code.size());
        const std::string_view line = without_ends(std::string_view(code).substr(at, end - at));
        const bool idle = line.empty() || (!macros && line.starts_with("#undef"));
        if (!idle) lines.append(line).append("\n");
        at = end + 1;
    }
    return lines;
}

}  // namespace gloam::site
