// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "shader/internal/outline.hpp"

namespace gloam::shader::internal {

// Kind, names and mentions of a declaration, from its code without comments and directives.
[[nodiscard]] Piece piece_of(std::string_view code);

// The piece of a #define or #undef; any other directive becomes a piece without a name.
[[nodiscard]] Piece macro_of(const Directive& directive);

}  // namespace gloam::shader::internal
