// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "catalogue/entry.hpp"
#include "check/prepared_check.hpp"

namespace gloam::site {

// A prepared check as JSON for the page (page/checks.js lists the members). Words and doubles are base64 of
// their little-endian bytes.
[[nodiscard]] std::string check_json(const catalogue::Description& description,
                                     const check::Question& question, const check::PreparedCheck& prepared);

}  // namespace gloam::site
