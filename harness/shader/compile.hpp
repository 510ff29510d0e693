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

// GLSL text, and the name by which error messages refer to it. The text starts with its own #version line:
// 430 to 460 (core), 310 es or 320 es.
struct Source {
    std::string name;
    std::string text;
};

struct CompileOptions {
    Stage stage = Stage::compute;
    // Folders for #include "a/b.glsl", searched after the includer's own folder. A Source has such a folder
    // if its name is a path with a folder.
    std::vector<std::filesystem::path> include_roots;
    Variant variant;     // how the module is changed after the front end
    bool lines = false;  // the module records the file and line of each instruction
};

// The compiler rejected the text. what() has one line for each message, "file:line: message", with the file
// that contains the error.
class CompileError : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

using Spirv = std::vector<std::uint32_t>;

// A text can be untrusted. compile(), functions(), excerpts(), pack() and translated() run the compiler in
// another process with limits: 60 s of processor time and 3 GiB of memory. A text that exceeds them, or that
// ends the compiler by a signal, is a CompileError. Includes must lie below the roots or the folder of the
// Source.

// Compiles GLSL for Vulkan 1.2 (SPIR-V 1.5) to a validated module of the variant; names are kept. #include
// needs no #extension line. Functions that main does not call may use prototypes without a body. Throws
// CompileError, also for an include that is missing or includes itself.
[[nodiscard]] Spirv compile(const Source& source, const CompileOptions& options);

// Compiles HLSL of shader model 6.0 without includes by glslang's HLSL front end, to a validated module of
// SPIR-V 1.3. The entry point is main; the number of a register is the binding in descriptor set 0. Buffers
// are storage buffers. Throws CompileError, also for uniform buffers.
[[nodiscard]] Spirv compile_hlsl(const Source& source, Stage stage);

// The functions that the text and its includes define, and the functions that they declare and call without a
// definition, in order of definition or first call. Types and names are those of the compiled module.
// Overloads are separate entries. The text needs no main; the variant has no effect. Throws like compile().
[[nodiscard]] std::vector<Function> functions(const Source& source, const CompileOptions& options);

// Name and version of the compiler, the optimizer, the validator and the translator back to GLSL; part of
// every cache key.
[[nodiscard]] std::string compiler_version();

}  // namespace gloam::shader
