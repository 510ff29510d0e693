// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "catalogue/entry.hpp"

namespace gloam::catalogue {

// The page docs/equations.md: a section for each room of the library, with the ID, title, formula, function,
// file, accuracy budget and source of every equation.
[[nodiscard]] std::string to_markdown(const Entries& entries);

}  // namespace gloam::catalogue
