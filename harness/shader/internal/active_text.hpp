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

// A file of a text, divided into lines that point into it.
struct TextFile {
    std::string name;
    std::string text;
    std::vector<Line> lines;
};

// The lines that the compiler reads of some files and their includes: conditions are evaluated and includes
// inserted, but macros are not replaced.
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

// Reads the texts in order, as the compiler for this language and stage does: its own preprocessor determines
// the active lines. Throws CompileError, for example for an include that is missing or includes itself, for
// #error, and for an invalid #version.
[[nodiscard]] ActiveText active_text(std::vector<Source> given, Language language, Stage stage,
                                     const std::vector<std::filesystem::path>& roots);

}  // namespace gloam::shader::internal
