// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/text.hpp"
#include "source/tokens.hpp"

namespace gloam::source {

// Without white space around it.
[[nodiscard]] std::string_view trimmed(std::string_view text);

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

// The tokens of a line of the text, with their places in the text. A directive has none.
[[nodiscard]] std::vector<Token> line_tokens(const Line& line, std::string_view text);

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

// A file of a text, divided into lines that point into it.
struct TextFile {
    std::string name;
    std::string text;
    std::vector<Line> lines;
};

// The lines that the compiler reads of some files and their includes: conditions are evaluated and includes
// inserted, but macros are not replaced.
struct ActiveText {
    struct Location {
        std::size_t file;
        std::size_t line;
    };
    std::deque<TextFile> files;  // those given first, then those included; a place keeps its address
    std::size_t given = 0;       // so many of them
    std::vector<Location>
        lines;  // of #define, #undef, #extension, #pragma and code; none of #if, #include, #version

    [[nodiscard]] const Line& at(const Location& place) const { return files[place.file].lines[place.line]; }
};

// Every line of a text, whatever its conditions.
[[nodiscard]] ActiveText whole_text(std::string text);

// Throws CompileError unless the first line of code is a #version that Vulkan supports in every stage.
// glslang must not see another version: for some it prints its tables to standard output.
void require_vulkan_version(const Source& source);

}  // namespace gloam::source
