// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::shader::internal {

// A logical line of the preprocessor, with the lines that a trailing backslash continues.
struct Line {
    std::string_view text;  // as written, with its newline
    std::string code;       // same length as text: comments are blanks, continuations are NUL
    int number = 1;         // of its first physical line
    bool crosses = false;   // a block comment enters or leaves it
};
[[nodiscard]] std::vector<Line> split_lines(std::string_view text);

// Only blanks and comments.
[[nodiscard]] bool is_blank(const Line& line);
// The comments of the line alone, code blanked.
[[nodiscard]] std::string comments_of(const Line& line);

// "#keyword argument", both without surrounding blanks.
struct Directive {
    std::string keyword;
    std::string argument;
};
[[nodiscard]] std::optional<Directive> directive_of(const Line& line);

// The name in an #include. `system`: the <name> form, for which the includer's own folder is not searched.
struct IncludeName {
    std::string name;
    bool system = false;
};
[[nodiscard]] std::optional<IncludeName> include_of(const Line& line);

}  // namespace gloam::shader::internal
