// SPDX-License-Identifier: MIT
#pragma once

#include <glslang/Public/ShaderLang.h>

#include <filesystem>
#include <string>
#include <vector>

#include "shader/compile.hpp"

namespace gloam::shader::internal {

// The rules of which client the text is held to: SPIR-V for Vulkan 1.2, or those of the language alone.
enum class Client { vulkan, none };

// What becomes of functions that main does not reach.
enum class Unreached { dropped, kept };

// A text parsed by glslang; several pieces are read as one, each with its own name and line numbers.
// The syntax tree lives as long as this object.
class Parse {
  public:
    // `name` is for messages without a place. Throws CompileError.
    Parse(Stage stage, Client client, std::string name, std::vector<Source> pieces,
          const std::vector<std::filesystem::path>& roots);
    Parse(const Parse&) = delete;
    Parse& operator=(const Parse&) = delete;

    // Checks what concerns the whole program (bodies of called functions, recursion) and drops the functions
    // of `unreached` if asked to. Throws CompileError.
    [[nodiscard]] const glslang::TIntermediate& link(Unreached unreached);

  private:
    EShLanguage language_;
    EShMessages messages_;
    std::string name_;
    std::vector<Source> pieces_;
    glslang::TShader shader_;
    glslang::TProgram program_;  // after the shader: must be destroyed first
};

// The text with its includes and macros replaced and its comments gone. Throws CompileError.
[[nodiscard]] std::string preprocessed(const Source& source, Stage stage,
                                       const std::vector<std::filesystem::path>& roots);

struct Translation {
    Unreached unreached = Unreached::dropped;
    bool lines = false;  // see CompileOptions
};

// The text for Vulkan as glslang translates it: no optimisation, not validated. Throws CompileError.
[[nodiscard]] Spirv to_spirv(const Source& source, Stage stage,
                             const std::vector<std::filesystem::path>& roots, const Translation& how = {});

}  // namespace gloam::shader::internal
