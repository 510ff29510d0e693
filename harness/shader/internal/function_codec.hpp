// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shader/type.hpp"

namespace gloam::shader::internal {

// Function descriptions as bytes, and back; nullopt for bytes that encode() did not make.
[[nodiscard]] std::string encode(const std::vector<Function>& functions);
[[nodiscard]] std::optional<std::vector<Function>> decode(std::string_view bytes);

}  // namespace gloam::shader::internal
