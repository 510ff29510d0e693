// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "check/answer.hpp"

namespace gloam::report {

// One line of JSON, and back. Reading restores the worst input without its fractions, the first unbounded
// input as text alone, and no first failures. It throws std::runtime_error with the field's name and what was
// expected.
[[nodiscard]] std::string to_json(const check::Answer& answer);
[[nodiscard]] check::Answer answer_from_json(std::string_view text);

}  // namespace gloam::report
