// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "source/declarations.hpp"

// What is kept of an outline: what is wanted, and all that it mentions.
namespace gloam::source {

// A function of this name, every declaration without a name, and what these use, in the order of the outline
// and without comments.
[[nodiscard]] std::vector<const Declaration*> kept_for(const Outline& outline, const std::string& function);

// The declarations of one text, and the functions for which they are kept.
struct Kept {
    std::vector<const Declaration*> declarations;
    std::vector<std::string> wanted;
};
// For these functions; of none main, otherwise all functions of the first `given` of the outline's files, and
// of texts without a function all that these declare. With its comments; what the user supplies stands first.
// Throws std::invalid_argument for a function that the outline lacks.
[[nodiscard]] Kept kept_in_order(const Outline& outline, std::size_t given,
                                 const std::vector<std::string>& functions);

// A comment that says how to call a text without a main: the functions to call (those that are wanted and
// that nothing else uses), the prototypes without a body that the caller has to define, with their meaning,
// and the structures of the parameters. Lines have at most 120 columns. Empty if there is nothing to define.
[[nodiscard]] std::string calling_comment(const Kept& kept);

}  // namespace gloam::source
