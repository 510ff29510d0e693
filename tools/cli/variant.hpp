// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "shader/variant.hpp"

namespace gloam::cli {

// The variant with this name; all variants for "all". Throws std::invalid_argument that lists the names.
[[nodiscard]] std::vector<shader::Variant> select_variants(const std::string& name);

}  // namespace gloam::cli
