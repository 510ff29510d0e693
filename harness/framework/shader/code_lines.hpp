// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gloam::shader {

// Lines with more than blanks and comments of texts that pack() wrote, together: a function, structure,
// constant or macro that several have counts once.
[[nodiscard]] std::size_t code_lines(const std::vector<std::string>& packed);

}  // namespace gloam::shader
