// SPDX-License-Identifier: MIT
#include "effect/settings.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "effect/setting_table.hpp"

namespace gloam::effect {
namespace {

constexpr std::uint32_t largest_half_count = 2048;  // integers up to it are exact in float16

}  // namespace

Settings with_radius(Settings settings, float radius) {
    check(setting_named("radius"), double{radius});
    const double scale = double{radius / settings.radius};
    for (const Setting& setting : setting_table()) {
        if (setting.unit != "world units" || setting.name == "radius") continue;
        setting.put(settings, std::get<double>(setting.get(settings)) * scale);
    }
    settings.radius = radius;
    return settings;
}

bool filters(const Settings& settings) {
    return settings.filter != Filter::none;
}

bool remaps(const Settings& settings) {
    return settings.remap_a != 0.0F || settings.remap_b != 1.0F || settings.remap_c != 1.0F;
}

void validate(const Settings& settings) {
    for (const Setting& setting : setting_table()) check(setting, setting.get(settings));
    if (settings.precision != HistoryPrecision::float16) return;
    for (const char* name : {"table_size", "weight_max"}) {
        const SettingValue value = setting_named(name).get(settings);
        if (std::get<double>(value) <= double{largest_half_count}) continue;
        throw std::invalid_argument(fmt::format("{} {}: expected at most {} with a history in float16", name,
                                                text_of(value), largest_half_count));
    }
}

}  // namespace gloam::effect
