// SPDX-License-Identifier: MIT
#pragma once

#include <glslang/Public/ShaderLang.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "shader/internal/include_folders.hpp"

namespace gloam::shader::internal {

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

}  // namespace gloam::shader::internal
