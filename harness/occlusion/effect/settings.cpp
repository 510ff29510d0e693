// SPDX-License-Identifier: MIT
#include "effect/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "effect/methods.hpp"

namespace gloam::effect {

bool reads(const Settings& settings, const Setting& setting) {
    return setting.read_by == (settings.passes == Passes::frame ? ReadBy::frame : ReadBy::study) ||
           setting.read_by == ReadBy::both;
}

std::uint32_t slices_of(const Settings& settings) {
    return std::max(settings.samples / (2 * settings.own.steps), 1U);
}

Settings with_radius(Settings settings, float radius) {
    check(setting_named("radius"), double{radius});
    const double scale = double{radius / settings.radius};
    for (const Setting& setting : setting_table()) {
        if (setting.unit != "world units" || setting.name == "radius") continue;
        if (!reads(settings, setting)) continue;
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

bool remaps(const Settings& settings) {
    return settings.remap_a != 0.0F || settings.remap_b != 1.0F || settings.remap_c != 1.0F ||
           settings.output != OutputFormat::r32f;
}

void validate(const Settings& settings) {
    for (const Setting& setting : setting_table()) {
        check(setting, setting.get(settings));
        if (!reads(settings, setting) && setting.get(settings) != setting.get(Settings{}))
            throw std::invalid_argument(
                fmt::format("{} {}: the passes of this preset do not read it; expected {}", setting.name,
                            text_of(setting.get(settings)), text_of(setting.get(Settings{}))));
    }
    if (settings.passes == Passes::frame && settings.method != "sweep")
        throw std::invalid_argument(
            fmt::format("method {}: expected sweep, the frame's, or passes=study", settings.method));
    if (settings.own.layers > 1 && !reads(method_named(settings.method), "layers"))
        throw std::invalid_argument(fmt::format("layers {}: expected 1, because {} sees one layer of depth",
                                                settings.own.layers, settings.method));
}

}  // namespace gloam::effect
