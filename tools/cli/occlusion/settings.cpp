// SPDX-License-Identifier: MIT
#include "cli/occlusion/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/files.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "cli/occlusion/render.hpp"
#include "effect/methods.hpp"

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

ordered_json json_of(const effect::Settings& settings) {
    ordered_json json = ordered_json::object();
    for (const effect::Setting& setting : effect::setting_table())
        if (reads(settings, setting)) json[setting.name] = json_of(setting.get(settings));
    return json;
}

effect::Settings preset_settings(const std::string& file) {
    if (!file.ends_with(".json")) return effect::preset_named(file).settings;
    const std::string text = base::read_file(file);
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

std::pair<std::string, std::string> assignment_of(const std::string& text) {
    const std::size_t sign = text.find('=');
    if (sign == std::string::npos)
        throw std::invalid_argument(fmt::format("--set {}: expected NAME=VALUE (gloam list settings)", text));
    return {text.substr(0, sign), text.substr(sign + 1)};
}

void apply(effect::Settings& settings, const std::string& assignment) {
    const auto [name, value] = assignment_of(assignment);
    if (name == "method" || name == "radius")
        throw std::invalid_argument(fmt::format("--set {}: expected --{} instead", assignment, name));
    effect::set(settings, name, value);
}

effect::Settings settings_for(const RenderCandidate& candidate, const std::optional<double>& view_radius) {
    effect::Settings settings = preset_settings(candidate.preset);
    if (!candidate.method.empty() && candidate.method != settings.method)
        settings = with_method(settings, candidate.method);
    if (!candidate.radius && !view_radius)
        throw std::invalid_argument("no radius: the G-buffer has no ao_radius, so give --radius");
    settings =
        with_radius(settings, candidate.radius.value_or(static_cast<float>(view_radius.value_or(1.0))));
    if (candidate.samples) settings.samples = *candidate.samples;
    if (candidate.no_filter) settings.filter = effect::Filter::none;
    if (candidate.bias) settings.bias = *candidate.bias;
    if (candidate.guard) settings.guard = *candidate.guard;
    if (settings.passes == effect::Passes::frame)
        settings.bent_normals = candidate.bent_normals && candidate.bent_interleave == 1;
    for (const std::string& assignment : candidate.set) apply(settings, assignment);
    validate(settings);
    return settings;
}

backend::Extent parse_size(const std::string& text, std::uint32_t least, std::uint32_t most) {
    const std::size_t times = std::min(text.find('x'), text.size());
    const auto side = [&](std::string_view number) {
        const auto pixels = base::number_from<std::uint32_t>(number);
        if (times < text.size() && pixels && *pixels >= least && *pixels <= most) return *pixels;
        throw std::invalid_argument(
            fmt::format("--size {}: expected WIDTHxHEIGHT in pixels, each {} {}, such as 640x360", text,
                        least, most == any_size ? "or more" : fmt::format("to {}", most)));
    };
    return {side(text.substr(0, times)), side(text.substr(std::min(times + 1, text.size())))};
}

}  // namespace gloam::cli
