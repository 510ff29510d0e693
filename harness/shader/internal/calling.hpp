// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "shader/internal/outline.hpp"

namespace gloam::shader::internal {

// The constants that the comments of a piece name: "FX_STEP" as it is, "FX_FALLOFF_*" for every name that
// begins so. Names have no lower-case letters.
[[nodiscard]] std::vector<std::string> constants_in_comments(const Piece& piece);

// A comment that says how to call a text without a main: the functions to call (those of `wanted` that no
// other piece uses), the prototypes without a body that the caller has to define, with their meaning, and the
// structures of the parameters. Lines have at most 120 columns. Empty if there is nothing to define.
[[nodiscard]] std::string calling_comment(const std::vector<const Piece*>& pieces,
                                          const std::vector<std::string>& wanted);

}  // namespace gloam::shader::internal
