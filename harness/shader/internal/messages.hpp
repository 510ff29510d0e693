// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace gloam::shader::internal {

// The errors of glslang's log as "file:line: message" lines. `file`: for messages without a place.
[[nodiscard]] std::string error_lines(const std::string& log, const std::string& file);

}  // namespace gloam::shader::internal
