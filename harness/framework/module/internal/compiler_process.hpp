// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "module/compile.hpp"
#include "module/texts.hpp"

// A compiler is a large program, and a text can be untrusted: a macro, a loop to unroll or a deep expression
// can exhaust it. Each public function that compiles a text therefore asks another process, one for each
// thread of this program, which has limits far beyond the needs of any reasonable shader: 60 s of processor
// time, 3 GiB of memory. A text that exceeds them, or that the compiler does not survive, is a CompileError.
namespace gloam::shader::internal {

// compile() and functions() with results as bytes, which module_of() and decode() read.
[[nodiscard]] std::string compiled_bytes(const Source& source, const CompileOptions& options);
[[nodiscard]] std::string functions_bytes(const Source& source, const CompileOptions& options);

// The module of these bytes; nullopt if they are no whole words.
[[nodiscard]] std::optional<Spirv> module_of(std::string_view bytes);

// The work itself, in this process: compile(), functions(), excerpts(), mutations(), pack() and
// translated() without limits.
[[nodiscard]] Spirv compile_here(const Source& source, const CompileOptions& options);
[[nodiscard]] std::vector<Function> functions_here(const Source& source, const CompileOptions& options);
[[nodiscard]] Excerpts excerpts_here(const Source& source, const std::vector<std::filesystem::path>& roots);
[[nodiscard]] std::string pack_here(const std::vector<Source>& sources, const PackRequest& request,
                                    const std::vector<std::filesystem::path>& roots, Stage stage);
[[nodiscard]] std::vector<Mutation> mutations_here(const Source& source,
                                                   const std::vector<std::filesystem::path>& roots);
[[nodiscard]] std::string translated_here(const Source& packed, Target target, Stage stage);

// Function descriptions as bytes, and back; nullopt for bytes that encode() did not make.
[[nodiscard]] std::string encode(const std::vector<Function>& functions);
[[nodiscard]] std::optional<std::vector<Function>> decode(std::string_view bytes);

}  // namespace gloam::shader::internal
