// SPDX-License-Identifier: MIT
#include "cli/setting_json.hpp"

#include <cmath>
#include <string>

namespace gloam::cli {

using nlohmann::ordered_json;

ordered_json json_of(const effect::SettingValue& value) {
    if (const auto* on = std::get_if<bool>(&value)) return *on;
    if (const auto* name = std::get_if<std::string>(&value)) return *name;
    const double number = std::get<double>(value);
    return std::isfinite(number) ? ordered_json::parse(effect::text_of(value)) : ordered_json("inf");
}

std::string text_of(const ordered_json& value) {
    if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
    if (value.is_string()) return value.get<std::string>();
    return value.dump();
}

ordered_json json_of(const effect::Setting& setting) {
    const effect::SettingValue value = setting.get(effect::Settings{});
    ordered_json json{{"name", setting.name},
                      {"description", setting.meaning},
                      {"unit", setting.unit},
                      {"expected", effect::expected_of(setting)}};
    if (!setting.choices.empty()) json["choices"] = setting.choices;
    if (std::holds_alternative<double>(value)) {
        json["least"] = setting.range.least;
        json["most"] =
            std::isfinite(setting.range.most) ? ordered_json(setting.range.most) : ordered_json(nullptr);
    }
    json["default"] = json_of(value);
    return json;
}

ordered_json json_of(const effect::Settings& settings) {
    ordered_json json = ordered_json::object();
    for (const effect::Setting& setting : effect::setting_table())
        json[setting.name] = json_of(setting.get(settings));
    return json;
}

}  // namespace gloam::cli
