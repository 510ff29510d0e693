// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "module/compile.hpp"
#include "source/lines.hpp"

// glslang, for the other sources of this room.
namespace gloam::module::internal {

// The folders in which includes are searched, and those below which they must lie.
struct IncludeFolders {
    std::vector<std::filesystem::path> roots;
    std::vector<std::filesystem::path> permitted;
};

// The roots; includes may also lie below the folder of each text whose name is a path with a folder.
[[nodiscard]] IncludeFolders include_folders(const std::vector<std::filesystem::path>& roots,
                                             const std::vector<source::Source>& texts);

// resolve_include() of these folders. Nothing about `from` is assumed, because #line can name any.
[[nodiscard]] std::filesystem::path resolved(std::string_view name, const std::filesystem::path& from,
                                             const IncludeFolders& folders);

// The rules that apply to the text: those of SPIR-V for Vulkan 1.2, or those of GLSL alone.
enum class Client { vulkan, none };
[[nodiscard]] Client client_of(source::Language language);

// What is checked: what the parser sees, or also the whole program: bodies of called functions, recursion.
enum class Check { text, program };

// Throws CompileError unless the pieces are valid. They are read as one text, each with its own name and line
// numbers. `name`: for messages without a place.
void check(source::Stage stage, Client client, const std::string& name,
           const std::vector<source::Source>& pieces, const std::vector<std::filesystem::path>& roots,
           Check what = Check::text);

// What the compiler is given in the place of an include's text.
using Reading = std::function<std::string(const std::filesystem::path&, std::string text)>;

// The preprocessed text of such pieces: includes and macros replaced, comments removed. Throws CompileError.
[[nodiscard]] std::string preprocessed(const std::vector<source::Source>& pieces, source::Stage stage,
                                       Client client, const IncludeFolders& folders,
                                       const Reading& reading = {});

// Reads the texts in order, as the compiler for this language and stage does: its own preprocessor determines
// the active lines. Throws CompileError, for example for an include that is missing or includes itself, for
// #error, and for an invalid #version.
[[nodiscard]] source::ActiveText active_text(const std::vector<source::Source>& given,
                                             source::Language language, source::Stage stage,
                                             const std::vector<std::filesystem::path>& roots);

// What happens to functions that main does not call.
enum class Unreached { dropped, kept };

// The text translated to SPIR-V by glslang, neither optimised nor validated. `lines`: as in CompileOptions.
// Throws CompileError.
[[nodiscard]] Spirv to_spirv(const source::Source& source, source::Stage stage,
                             const std::vector<std::filesystem::path>& roots,
                             Unreached unreached = Unreached::dropped, bool lines = false);

}  // namespace gloam::module::internal
