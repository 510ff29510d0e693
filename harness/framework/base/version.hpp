// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace gloam::base {

// The version of gloam, "0.4.0": project(VERSION) of the CMakeLists.txt. All that gloam writes begins with
// it.
[[nodiscard]] std::string version();

}  // namespace gloam::base
