// SPDX-License-Identifier: MIT
#pragma once

#include <glslang/Public/ShaderLang.h>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "module/compile.hpp"
#include "module/internal/include_folders.hpp"
#include "source/lines.hpp"

namespace gloam::module::internal {

// Serves #include from files. An include's name is its path, which error messages then contain. The text
// passed to the compiler can differ from the file's.
// glslang is built without exceptions, so nothing may be thrown through it: failures become messages.
class Includer final : public glslang::TShader::Includer {
  public:
    using Reading = std::function<std::string(const std::filesystem::path&, std::string text)>;
    explicit Includer(IncludeFolders folders, Reading reading = {})
        : folders_(std::move(folders)), reading_(std::move(reading)) {}

    IncludeResult* includeLocal(const char* name, const char* includer, std::size_t depth) override;
    IncludeResult* includeSystem(const char* name, const char* includer, std::size_t depth) override;
    void releaseInclude(IncludeResult* result) override;

  private:
    struct Open {
        std::filesystem::path path;
        std::string text;
        std::unique_ptr<IncludeResult> result;
    };

    IncludeResult* open(const char* name, const std::filesystem::path& from);
    IncludeResult* fail(std::string message);
    IncludeResult* hold(std::filesystem::path path, std::string text);
    [[nodiscard]] std::string chain_to(const std::filesystem::path& path) const;

    IncludeFolders folders_;
    Reading reading_;
    std::vector<std::unique_ptr<Open>> open_;
    std::size_t included_ = 0;  // files so far
    std::optional<std::string> local_failure_;
};

// The rules that apply to the text: those of SPIR-V for Vulkan 1.2, or those of GLSL alone.
enum class Client { vulkan, none };
[[nodiscard]] Client client_of(source::Language language);

// What happens to functions that main does not call.
enum class Unreached { dropped, kept };

// Texts in glslang's form. The texts must outlive it.
class Strings {
  public:
    explicit Strings(const std::vector<source::Source>& pieces);
    void give_to(glslang::TShader& shader) const;

  private:
    std::vector<const char*> texts_;
    std::vector<int> lengths_;
    std::vector<std::string> shown_;
    std::vector<const char*> names_;
};

// A text parsed by glslang. Several pieces are read as one text, each with its own name and line numbers. The
// syntax tree lives as long as this object.
class Parse {
  public:
    // `name`: for messages without a place. Throws CompileError.
    Parse(source::Stage stage, Client client, std::string name, std::vector<source::Source> pieces,
          const std::vector<std::filesystem::path>& roots);
    Parse(const Parse&) = delete;
    Parse& operator=(const Parse&) = delete;

    // Checks the whole program (bodies of called functions, recursion), and drops unreached functions if
    // `unreached` requires it. Throws CompileError.
    [[nodiscard]] const glslang::TIntermediate& link(Unreached unreached);

  private:
    EShLanguage language_;
    EShMessages messages_;
    std::string name_;
    std::vector<source::Source> pieces_;
    Strings strings_;
    glslang::TShader shader_;
    glslang::TProgram program_;  // after the shader: must be destroyed first
};

// The preprocessed text: includes and macros replaced, comments removed. Throws CompileError.
[[nodiscard]] std::string preprocessed(const source::Source& source, source::Stage stage,
                                       const std::vector<std::filesystem::path>& roots);

// The same for several texts that are read as one, by the rules of the client.
[[nodiscard]] std::string preprocessed(const std::vector<source::Source>& pieces, source::Stage stage,
                                       Client client, glslang::TShader::Includer& includer);

// Reads the texts in order, as the compiler for this language and stage does: its own preprocessor determines
// the active lines. Throws CompileError, for example for an include that is missing or includes itself, for
// #error, and for an invalid #version.
[[nodiscard]] source::internal::ActiveText active_text(std::vector<source::Source> given,
                                                       source::Language language, source::Stage stage,
                                                       const std::vector<std::filesystem::path>& roots);

// The text translated to SPIR-V by glslang, neither optimised nor validated. `lines`: as in CompileOptions.
// Throws CompileError.
[[nodiscard]] Spirv to_spirv(const source::Source& source, source::Stage stage,
                             const std::vector<std::filesystem::path>& roots,
                             Unreached unreached = Unreached::dropped, bool lines = false);

}  // namespace gloam::module::internal
