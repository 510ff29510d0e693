// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "module/texts.hpp"

namespace gloam::check {

// A user's shader file, cut into its functions once. Labs that run them share it.
struct OwnFile {
    // `text`: what the file holds. `roots`: folders of its includes. `defines`: macros that hold before it
    // begins (shader::excerpts()). Throws shader::CompileError for what the preprocessor rejects.
    OwnFile(const std::filesystem::path& path, std::string contents, std::vector<std::filesystem::path> roots,
            const std::vector<std::string>& defines = {})
        : name(path.filename().string()),
          text(std::move(contents)),
          include_roots(std::move(roots)),
          excerpts(shader::excerpts({path.string(), text}, include_roots, defines)) {}

    // Null: it defines no such function.
    [[nodiscard]] const shader::Excerpt* find(const std::string& function) const {
        const auto found = std::ranges::find(excerpts.functions, function, &shader::Excerpt::function);
        return found == excerpts.functions.end() ? nullptr : &*found;
    }

    std::string name;  // without its folder, as kernels and reports call it
    std::string text;
    std::vector<std::filesystem::path> include_roots;
    shader::Excerpts excerpts;
};

}  // namespace gloam::check
