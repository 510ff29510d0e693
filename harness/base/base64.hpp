// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

namespace gloam::base {

// Bytes as base64 (RFC 4648, section 4), with padding.
[[nodiscard]] std::string base64(std::span<const unsigned char> bytes);

}  // namespace gloam::base
