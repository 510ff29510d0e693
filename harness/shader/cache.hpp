// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "shader/compile.hpp"

namespace gloam::shader {

// Compiled modules on disk, keyed by the text, every included file, the options and the compiler. A damaged,
// truncated or foreign entry is recompiled and replaced silently. Files are written completely or not at all.
// An unwritable directory costs only speed. Processes can share the directory.
class SpirvCache {
  public:
    // An empty directory means no cache.
    explicit SpirvCache(std::filesystem::path directory = {});

    // compile(source, options), or the stored result of an identical call.
    [[nodiscard]] Spirv compile(const Source& source, const CompileOptions& options) const;

    // functions(source, options), or the stored result of an identical call.
    [[nodiscard]] std::vector<Function> functions(const Source& source, const CompileOptions& options) const;

  private:
    std::filesystem::path directory_;
};

}  // namespace gloam::shader
