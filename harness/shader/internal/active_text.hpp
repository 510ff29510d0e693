// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <string>
#include <vector>

#include "shader/internal/lines.hpp"
#include "shader/language.hpp"

namespace gloam::shader::internal {

// A file that a text is made of, in lines that point into it.
struct TextFile {
    std::string name;
    std::string text;
    std::vector<Line> lines;
};

// The lines that the compiler reads of some files and all that they include: every condition is decided,
// every include in its place, macros as they stand.
struct ActiveText {
    struct Place {
        std::size_t file;
        std::size_t line;
    };
    std::deque<TextFile> files;  // those given first, then those included; a place keeps its address
    std::size_t given = 0;       // so many of them
    std::vector<Place>
        lines;  // of #define, #undef, #extension, #pragma and code; none of #if, #include, #version

    [[nodiscard]] const Line& at(const Place& place) const { return files[place.file].lines[place.line]; }
};

// Reads the texts one after the other, as the compiler of that language and stage does: its own preprocessor
// decides what is active. Throws CompileError (an include that is missing or includes itself, #error), and
// for a #version that is none.
[[nodiscard]] ActiveText active_text(std::vector<Source> given, Language language, Stage stage,
                                     const std::vector<std::filesystem::path>& roots);

}  // namespace gloam::shader::internal
