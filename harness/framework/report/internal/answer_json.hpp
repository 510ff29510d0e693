// SPDX-License-Identifier: MIT
#pragma once

#include "check/answer.hpp"
#include "report/json.hpp"

namespace gloam::report::internal {

[[nodiscard]] nlohmann::ordered_json answer_json(const check::Answer& answer);
[[nodiscard]] check::Answer read_answer(const JsonReader& json);

}  // namespace gloam::report::internal
