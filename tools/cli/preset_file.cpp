// SPDX-License-Identifier: MIT
#include "cli/preset_file.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/json_bounds.hpp"
#include "cli/read_text.hpp"
#include "cli/setting_json.hpp"
#include "effect/presets.hpp"
#include "effect/setting_table.hpp"

namespace gloam::cli {

using nlohmann::ordered_json;

std::string preset_json(const std::string& name, const std::string& description,
                        const effect::Settings& settings) {
    return ordered_json{{"name", name}, {"description", description}, {"settings", json_of(settings)}}.dump(
               2) +
           "\n";
}

effect::Settings preset_from(const std::string& file, std::string_view text) {
    try {
        base::require_bounded_json(text);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("preset {}: {}", file, error.what()));
    }
    const ordered_json document = ordered_json::parse(text, nullptr, false);
    if (!document.is_object() || !document.contains("settings") || !document["settings"].is_object())
        throw std::runtime_error(fmt::format("preset {}: expected JSON with an object \"settings\"", file));
    effect::Settings settings;
    try {
        for (const auto& [name, value] : document["settings"].items())
            effect::set(settings, name, text_of(value));
        validate(settings);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(fmt::format("preset {}: {}", file, error.what()));
    }
    if (settings.radius != 1.0F)
        throw std::invalid_argument(
            fmt::format("preset {}: radius {}, expected 1: --radius scales it", file, settings.radius));
    return settings;
}

effect::Settings preset_settings(const std::string& name_or_file) {
    if (!name_or_file.ends_with(".json")) return effect::preset_named(name_or_file).settings;
    return preset_from(name_or_file, read_text(name_or_file));
}

}  // namespace gloam::cli
