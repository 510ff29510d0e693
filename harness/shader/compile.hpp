// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "shader/type.hpp"
#include "shader/variant.hpp"

namespace gloam::shader {

enum class Stage { compute, vertex, fragment };

// GLSL text with the name that error messages give it. The text starts with its own #version line: 430 to 460
// (core), 310 es or 320 es.
struct Source {
    std::string name;
    std::string text;
};

struct CompileOptions {
    Stage stage = Stage::compute;
    // Where #include "a/b.glsl" is looked for, after the includer's own folder. A Source has one when its
    // name is a path with a folder in it.
    std::vector<std::filesystem::path> include_roots;
    Variant variant;     // what is done to the module after the front end
    bool lines = false;  // the module says which line of which file each instruction comes from
};

// The compiler rejected the text; what() has one line per message, each "file:line: message" with the file of
// the *include*.
class CompileError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

using Spirv = std::vector<std::uint32_t>;

// GLSL for Vulkan 1.2 (SPIR-V 1.5) to a validated module of the variant; names are kept. #include needs no
// #extension line. Functions that main does not reach may call prototypes without a body. Throws
// CompileError, also for an include that is missing or that includes itself.
[[nodiscard]] Spirv compile(const Source& source, const CompileOptions& options);

// Every function that the text and its includes define, and every one that they only declare and call (a
// declaration that nothing calls is not seen), in order of definition or first call; types and names are
// those of the compiled module. Overloads are separate entries. The text needs no main; the variant does not
// matter. Throws like compile().
[[nodiscard]] std::vector<Function> functions(const Source& source, const CompileOptions& options);

// Name and version of the compiler, the optimiser, the validator and the translator back to GLSL; part of
// every cache key.
[[nodiscard]] std::string compiler_version();

}  // namespace gloam::shader
