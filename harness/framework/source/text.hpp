// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

// A GLSL text, and what is known of its language.
namespace gloam::source {

enum class Stage { compute, vertex, fragment };

// GLSL text, and the name by which error messages refer to it. The text starts with its own #version line:
// 430 to 460 (core), 310 es or 320 es.
struct Source {
    std::string name;
    std::string text;
};

// The stage that the ending of a file names, in small or capital letters: .comp and .cs; .vert, .vs and .vsh;
// .frag, .fs and .fsh. nullopt for any other.
[[nodiscard]] std::optional<Stage> stage_of_file(const std::filesystem::path& file);

// The compiler rejected the text. what() has one line for each message, "file:line: message", with the file
// that contains the error.
class CompileError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The GLSL versions that the library promises to compile as.
enum class Language { vulkan450, gl430, gl330, gl150, es300, es310, es320 };

// "450", "430", "330", "150", "300es", "310es", "320es"; nullopt for other text.
[[nodiscard]] std::optional<Language> language_from(std::string_view name);
[[nodiscard]] std::string to_string(Language language);

// The first lines of a text: #version, extensions of 150, and for ES the default precisions (highp).
[[nodiscard]] std::string preamble(Language language);

// The stage in which a text of this language is checked by default: compute if the language has it, otherwise
// fragment.
[[nodiscard]] Stage usual_stage(Language language);

enum class Direction { in, out, inout };

// "sampler2D", "sampler2DArray", "sampler3D", "samplerCube", "samplerCubeArray" and those of integers,
// "isampler2D" and "usampler2D"; and "sampler2DShadow".
[[nodiscard]] bool is_sampler_type(std::string_view name);

// Whether the word is a type without values: "sampler2D", "uimageBuffer", "atomic_uint".
[[nodiscard]] bool is_opaque(std::string_view word);

}  // namespace gloam::source
