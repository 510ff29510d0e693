// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "shader/compile.hpp"

namespace gloam::shader {

// A fault that a text can be given: `after` in the place of the bytes from `begin` to `end`.
struct Mutation {
    std::size_t begin = 0;
    std::size_t end = 0;
    int line = 1;
    std::string before;
    std::string after;
    // "operator", "comparison", "loop bound", "condition", "constant", "function", "statement"
    std::string kind;
    std::string function;  // whose body it is in; empty: outside of all

    friend bool operator==(const Mutation&, const Mutation&) = default;
};

// The faults of a text, in its order, without those of its includes: other operators, comparisons, constants
// and functions, conditions that always or never hold, and statements left out. Comments, directives,
// structures and the interface are left alone, and so is what a condition of the preprocessor leaves out. A
// fault may not compile. Throws CompileError for a text that the compiler rejects.
[[nodiscard]] std::vector<Mutation> mutations(const Source& source,
                                              const std::vector<std::filesystem::path>& roots);

// The text with this fault.
[[nodiscard]] std::string mutated(std::string text, const Mutation& mutation);

}  // namespace gloam::shader
