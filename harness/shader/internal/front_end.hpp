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

// A text parsed by glslang; several pieces are read as one, each with its own name and line numbers.
// The syntax tree lives as long as this object.
class Parse {
  public:
    // `name` is for messages without a place. Throws CompileError.
    Parse(Stage stage, Client client, std::string name, std::vector<Source> pieces,
          const std::vector<std::filesystem::path>& roots);
    Parse(const Parse&) = delete;
    Parse& operator=(const Parse&) = delete;

    // Before link(): with every function of the text. Valid while this object lives.
    [[nodiscard]] const glslang::TIntermediate& tree() const { return *shader_.getIntermediate(); }

    // Checks what concerns the whole program (bodies of reached functions, recursion) and drops unreached
    // functions. Throws CompileError.
    [[nodiscard]] const glslang::TIntermediate& link();

  private:
    EShLanguage language_;
    EShMessages messages_;
    std::string name_;
    std::vector<Source> pieces_;
    glslang::TShader shader_;
    glslang::TProgram program_;  // after the shader: must be destroyed first
};

// The text for Vulkan as glslang translates it: no optimisation, not validated. Throws CompileError.
[[nodiscard]] Spirv to_spirv(const Source& source, Stage stage,
                             const std::vector<std::filesystem::path>& roots);

}  // namespace gloam::shader::internal
