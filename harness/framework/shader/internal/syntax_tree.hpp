// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gloam::shader::internal {

// What the front end knows of the tokens of a text, by their line: each token has a line of its own, because
// its syntax tree has lines and no columns.
struct TokenTypes {
    // Of the parameters of a call or a constructor, by the line of its closing bracket.
    std::map<int, std::vector<std::string>> arguments;
    // Of the vector whose components these are, by their line: 2 to 4.
    std::map<int, std::size_t> components;
    // Other members of the structure that have the type of this one, by its line.
    std::map<int, std::vector<std::string>> members;
};

// Reads the syntax tree as glslang prints it.
[[nodiscard]] TokenTypes token_types(std::string_view tree);

}  // namespace gloam::shader::internal
