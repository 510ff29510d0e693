// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "effect/setting_table.hpp"

namespace gloam::cli {

// true or false, a number with the digits of single precision, or a name; infinity is "inf".
[[nodiscard]] nlohmann::ordered_json json_of(const effect::SettingValue& value);

// The same as text that effect::set() reads: "on", "off", a number or a name.
[[nodiscard]] std::string text_of(const nlohmann::ordered_json& value);

// {"name", "description", "unit", "expected", "least", "most" or "choices", "default"}: the default is the
// preset `paper`'s, lengths for a radius of 1; "most" is null where there is none.
[[nodiscard]] nlohmann::ordered_json json_of(const effect::Setting& setting);

// The value of every setting, by its name.
[[nodiscard]] nlohmann::ordered_json json_of(const effect::Settings& settings);

}  // namespace gloam::cli
