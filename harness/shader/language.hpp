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
enum class Language { vulkan450, gl330, es300, es310, es320 };

// "450", "330", "300es", "310es", "320es"; nullopt for other text.
[[nodiscard]] std::optional<Language> language_from(std::string_view name);
[[nodiscard]] std::string to_string(Language language);

// The first lines of a text: #version, and for ES the default precisions (highp).
[[nodiscard]] std::string preamble(Language language);

// The stage in which a text of this language is checked by default: compute if the language has it, otherwise
// fragment.
[[nodiscard]] Stage usual_stage(Language language);

// Parses a complete text of this stage, including its #version line; adds an empty main if there is none.
// Throws CompileError.
void check_program(const Source& text, bool add_main, Language language, Stage stage);

// Parses `body` (no #version line; includes allowed) behind the preamble; adds an empty main. It is a compute
// shader if the language has them, otherwise a fragment shader. Throws CompileError.
void check_compiles(const Source& body, Language language,
                    const std::vector<std::filesystem::path>& include_roots);

}  // namespace gloam::shader
