// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shader/compile.hpp"

namespace gloam::shader {

// The GLSL versions that the library promises to compile as.
enum class Language { vulkan450, gl330, es300, es310 };

// "450", "330", "300es", "310es"; nothing for another text.
[[nodiscard]] std::optional<Language> language_from(std::string_view name);
[[nodiscard]] std::string to_string(Language language);

// The lines that must come first: #version, and for ES the default precisions (highp).
[[nodiscard]] std::string preamble(Language language);

// The stage in which text of that language is checked where nothing else says so: compute where the language
// has it, else fragment.
[[nodiscard]] Stage usual_stage(Language language);

// Parses a whole text of that stage, its #version line first; adds an empty main where it has none. Throws
// CompileError.
void check_program(const Source& text, bool add_main, Language language, Stage stage);

// Parses `body` (no #version line; includes allowed) behind the preamble, as a compute shader where the
// language has them and a fragment shader elsewhere; adds an empty main. Throws CompileError.
void check_compiles(const Source& body, Language language,
                    const std::vector<std::filesystem::path>& include_roots);

}  // namespace gloam::shader
