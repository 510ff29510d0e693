// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "module/compile.hpp"

namespace gloam::cli {

// The variant with this name; all variants for "all". Throws std::invalid_argument that lists the names.
[[nodiscard]] std::vector<shader::Variant> select_variants(const std::string& name);

// "gloam 0.3.0, glslang 11.13.0 (generator 10), SPIRV-Tools v2022.4, SPIRV-Cross ...": the versions on which
// a result depends, besides the device and its driver.
[[nodiscard]] std::string versions();

}  // namespace gloam::cli
