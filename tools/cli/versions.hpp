// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace gloam::cli {

// "gloam 0.1.0, glslang 11.13.0 (generator 10), SPIRV-Tools v2022.4, SPIRV-Cross ...": the versions on which
// a result depends, besides the device and its driver.
[[nodiscard]] std::string versions();

}  // namespace gloam::cli
