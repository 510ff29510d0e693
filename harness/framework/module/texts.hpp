// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/excerpts.hpp"
#include "source/mutations.hpp"
#include "source/pack.hpp"

// Texts made of texts, with the compiler's help.
namespace gloam::module {

// The texts with their includes as one: packed(). `defines`: as those of excerpts(). The result has been
// compiled. Throws CompileError (for the original texts, if the error is there), std::invalid_argument for a
// function that the texts do not have, std::runtime_error for a file that cannot be read.
[[nodiscard]] std::string pack(const std::vector<std::filesystem::path>& files,
                               const source::PackRequest& request,
                               const std::vector<std::filesystem::path>& roots,
                               const std::vector<std::string>& defines = {});
[[nodiscard]] std::string pack(const std::vector<source::Source>& sources, const source::PackRequest& request,
                               const std::vector<std::filesystem::path>& roots);

// The functions of a text. The text may have any #version and any stage; it is read as GLSL 4.50 for Vulkan,
// and need not be valid. Throws CompileError for what the preprocessor rejects, for example a missing
// include. `defines`: macros that hold before the text begins, NAME or NAME=VALUE.
[[nodiscard]] source::Excerpts excerpts(const source::Source& source,
                                        const std::vector<std::filesystem::path>& roots,
                                        const std::vector<std::string>& defines = {});

// The lines that define them. Throws std::invalid_argument for what is neither NAME nor NAME=VALUE.
[[nodiscard]] std::string definitions_of(const std::vector<std::string>& defines);

// The faults of a text, in its order, without those of its includes: other operators, comparisons, constants
// and functions, conditions that always or never hold, and statements left out. Comments, directives,
// structures and the interface are left alone, and so is what a condition of the preprocessor leaves out. A
// fault may not compile. Throws CompileError for what the preprocessor rejects.
[[nodiscard]] std::vector<source::Mutation> mutations(const source::Source& source,
                                                      const std::vector<std::filesystem::path>& roots);

// Parses `body` (no #version line; includes allowed) behind the preamble; adds an empty main. It is a compute
// shader if the language has them, otherwise a fragment shader. Throws CompileError.
void check_compiles(const source::Source& body, source::Language language,
                    const std::vector<std::filesystem::path>& roots);

// Throws CompileError for a text that is valid in no stage, by the rules neither of Vulkan nor of OpenGL. A
// text without #version is GLSL 4.50.
void require_valid(const source::Source& source, const std::vector<std::filesystem::path>& roots);

// Shading languages other than GLSL.
enum class Target { hlsl, msl };

// "hlsl", "msl"; nullopt for other text.
[[nodiscard]] std::optional<Target> target_from(std::string_view name);

// The suffix of a file: ".hlsl", ".metal".
[[nodiscard]] std::string suffix(Target target);

// A text that pack() wrote for Vulkan, as SPIRV-Cross translates it, with the licences of the text above it:
// HLSL of shader model 6.0, or Metal Shading Language 2.1. The numbers of registers and indices are those of
// the bindings; push constants have the number after the last one. The entry point is main in HLSL, main0 in
// MSL. A text without a main gets one that calls every function, and functions that its user defines get a
// body that returns an undefined `gloam_result`. Throws CompileError if the text does not compile;
// std::invalid_argument for what cannot be translated.
[[nodiscard]] std::string translated(const source::Source& packed, Target target,
                                     source::Stage stage = source::Stage::compute);

}  // namespace gloam::module
