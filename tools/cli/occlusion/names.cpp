// SPDX-License-Identifier: MIT
#include "cli/occlusion/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "catalogue/catalogue.hpp"
#include "cli/environment.hpp"
#include "cli/occlusion/settings.hpp"
#include "effect/methods.hpp"
#include "effect/settings.hpp"
#include "scene/scene.hpp"

namespace gloam::cli {
namespace {

template <class Items>
std::vector<Named> named(const Items& items) {
    std::vector<Named> names;
    for (const auto& item : items) names.push_back({item.name, item.description});
    return names;
}

}  // namespace

std::vector<Named> method_names() {
    return named(effect::methods());
}

std::vector<Named> preset_names() {
    std::vector<Named> names;
    for (const effect::Preset& preset : effect::presets())
        names.push_back({preset.name, fmt::format("error {:.3f}, {:.2f} times the time of fast: {}",
                                                  preset.error, preset.time, preset.description)});
    return names;
}

std::vector<Named> setting_names() {
    std::vector<Named> names;
    for (const effect::Setting& setting : effect::setting_table()) {
        const effect::Preset preset = default_preset_of(setting);
        const std::string value = effect::text_of(setting.get(preset.settings));
        const std::string unit = setting.unit.empty() ? "" : " " + setting.unit;
        names.push_back({setting.name, fmt::format("{} ({}: {}{}; {})", setting.meaning, preset.name, value,
                                                   unit, expected_of(setting))});
    }
    return names;
}

std::vector<Named> scene_names() {
    std::vector<scene::ViewInfo> scenes = scene::all_views();
    std::erase_if(scenes, [](const scene::ViewInfo& view) { return view.kind != "scene"; });
    return named(scenes);
}

std::vector<Named> view_names() {
    std::vector<Named> names;
    for (const auto& [name, kind, what, half] : scene::all_views())
        if (!half.empty()) names.push_back({name, fmt::format("{} ({} half; {})", what, half, kind)});
    return names;
}

std::vector<Named> names_of(const std::vector<catalogue::PrintedRow>& rows) {
    std::vector<Named> names;
    for (const catalogue::PrintedRow& row : rows) {
        std::string more =
            row.places.size() > 1
                ? fmt::format("{}: ", fmt::join(row.places.begin() + 1, row.places.end(), "; "))
                : "";
        names.push_back(
            {row.places.front(), fmt::format("{}{}: {}", more, row.says, fmt::join(row.has, ", "))});
    }
    return names;
}

catalogue::Found found_named(const std::vector<std::string>& names) {
    catalogue::Found found = catalogue::find(catalogue::all_entries(glsl_directory()), names);
    if (found.several.empty()) return found;
    for (const auto& [name, says] : names_of(found.rows)) fmt::print(stderr, "{}: {}\n", name, says);
    throw std::invalid_argument(
        fmt::format("\"{}\" fits several rows: expected the name of one", found.several));
}

catalogue::Entries entries_named(const std::vector<std::string>& names) {
    catalogue::Found found = found_named(names);
    const std::vector<Named> rows = names_of(found.rows);
    if (!found.lacking.empty())
        throw std::invalid_argument(fmt::format("\"{}\" has no function: {}: {}", found.lacking,
                                                rows.back().name, rows.back().description));
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (found.rows[i].has.back().starts_with('('))
            fmt::print(stderr, "{}: {}\n", rows[i].name, rows[i].description);
    return std::move(found.entries);
}

std::vector<check::Question> equations_named(const std::vector<std::string>& names) {
    std::vector<check::Question> questions;
    for (catalogue::Entry& entry : entries_named(names)) questions.push_back(std::move(entry.question));
    return questions;
}

}  // namespace gloam::cli
