// SPDX-License-Identifier: MIT
#include "effect/settings.hpp"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <string>

#include "effect/methods.hpp"

namespace gloam::effect {
namespace {

// The largest value of a setting that a history can hold.
struct Limit {
    HistoryPrecision precision;
    const char* setting;
    double most;
};
constexpr std::array limits{Limit{HistoryPrecision::packed, "table_size", 65536.0},
                            Limit{HistoryPrecision::packed, "weight_max", 4095.0}};

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

bool shows_alone(const Settings& settings) {
    return !settings.history && !filters(settings);
}

bool maps(const Settings& settings) {
    return settings.remap_a != 0.0F || settings.remap_b != 1.0F || settings.remap_c != 1.0F;
}

bool remaps(const Settings& settings) {
    return maps(settings) || settings.output != OutputFormat::r32f;
}

void validate(const Settings& settings) {
    for (const Setting& setting : setting_table()) check(setting, setting.get(settings));
    if (settings.own.layers > 1 && !reads(method_named(settings.method), "layers"))
        throw std::invalid_argument(fmt::format("layers {}: expected 1, because {} sees one layer of depth",
                                                settings.own.layers, settings.method));
    for (const Limit& limit : limits) {
        if (limit.precision != settings.precision) continue;
        const SettingValue value = setting_named(limit.setting).get(settings);
        if (std::get<double>(value) <= limit.most) continue;
        throw std::invalid_argument(fmt::format("{} {}: expected at most {} with a history in {}",
                                                limit.setting, text_of(value), limit.most,
                                                name_of(settings.precision)));
    }
}

}  // namespace gloam::effect
