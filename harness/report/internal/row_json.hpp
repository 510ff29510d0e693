// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "report/check_row.hpp"
#include "report/internal/json_fields.hpp"

namespace gloam::report::internal {

[[nodiscard]] nlohmann::ordered_json row_json(const CheckRow& row);
[[nodiscard]] CheckRow read_row(const JsonReader& json);

}  // namespace gloam::report::internal
