// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "source/lines.hpp"

namespace gloam::source {

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

// The faults of the one text that was given, in its order.
[[nodiscard]] std::vector<Mutation> mutations(const ActiveText& text);

// The text with this fault.
[[nodiscard]] std::string mutated(std::string text, const Mutation& mutation);

}  // namespace gloam::source
