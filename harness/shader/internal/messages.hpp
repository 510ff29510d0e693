// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace gloam::shader::internal {

// glslang's log as "file:line: message" lines, errors only; a message without a place gets `file` as its
// file.
[[nodiscard]] std::string error_lines(const std::string& log, const std::string& file);

}  // namespace gloam::shader::internal
