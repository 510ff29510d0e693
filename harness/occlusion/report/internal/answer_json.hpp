// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "report/answer_json.hpp"
#include "report/internal/json_fields.hpp"

namespace gloam::report::internal {

[[nodiscard]] nlohmann::ordered_json answer_json(const check::Answer& answer);
[[nodiscard]] check::Answer read_answer(const JsonReader& json);

}  // namespace gloam::report::internal
