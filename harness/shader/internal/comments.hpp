// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "shader/internal/outline.hpp"

namespace gloam::shader::internal {

// The comments of a GLSL text, found again by the names of what they describe: translators drop comments.
class Comments {
  public:
    explicit Comments(const Outline& glsl);

    // The comment above the function with this name; of several the one whose parameters resemble these most.
    // Ends with a newline; empty if there is none.
    [[nodiscard]] std::string above_function(const Piece& translated) const;

    // The comment above a structure, a block, a constant or a resource.
    [[nodiscard]] std::string above(const std::string& name) const;

    // The comment behind a member of a structure or block, or behind a resource (block: ""): "// text",
    // several lines if the comment goes on below.
    [[nodiscard]] std::string behind(const std::string& block, const std::string& member) const;

    // The names of the variables of a block: "parameters" of "uniform Parameters { ... } parameters;".
    [[nodiscard]] std::vector<std::string> instances(const std::string& block) const;

  private:
    struct OfFunction {
        std::vector<std::string> parameters;  // their types and names
        std::string comment;
    };
    std::multimap<std::string, OfFunction> functions_;
    std::map<std::string, std::string> above_;
    std::map<std::string, std::map<std::string, std::string>> behind_;
    std::map<std::string, std::vector<std::string>> instances_;
};

}  // namespace gloam::shader::internal
