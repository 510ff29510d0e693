// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>

namespace gloam::shader::internal::wgsl {

// Whether WGSL reserves the word: keywords and the names of predeclared types.
[[nodiscard]] bool is_reserved(const std::string& word);
// Whether it is the name of a predeclared function of WGSL.
[[nodiscard]] bool is_builtin(const std::string& word);

// An identifier of WGSL like this name; "unnamed" where nothing is left of it.
[[nodiscard]] std::string identifier(const std::string& name);

// Names that are used, each once.
class Names {
  public:
    // The name, or the name with a number where it is taken; it is taken then.
    std::string take(const std::string& wanted);
    void reserve(const std::string& name) { taken_.insert(name); }
    [[nodiscard]] bool has(const std::string& name) const { return taken_.contains(name); }

  private:
    std::set<std::string> taken_;
};

}  // namespace gloam::shader::internal::wgsl
