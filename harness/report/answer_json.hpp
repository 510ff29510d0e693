// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "check/answer.hpp"

namespace gloam::report {

// One line of JSON, and back: the worst input comes back without its fractions, the first for which the rules
// permit anything as text alone, and the first failures of each class not at all. Reading throws
// std::runtime_error that names the field and what was expected.
[[nodiscard]] std::string to_json(const check::Answer& answer);
[[nodiscard]] check::Answer answer_from_json(std::string_view text);

}  // namespace gloam::report
