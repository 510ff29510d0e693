// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "backend/vulkan/resources.hpp"
#include "effect/methods.hpp"
#include "effect/settings.hpp"

namespace gloam::cli {

struct RenderCandidate;

// true or false, a number with the digits of single precision, or a name; infinity is "inf".
[[nodiscard]] nlohmann::ordered_json json_of(const effect::SettingValue& value);

// The same as text that effect::set() reads: "on", "off", a number or a name.
[[nodiscard]] std::string text_of(const nlohmann::ordered_json& value);

// The value of every setting that the passes read, by its name.
[[nodiscard]] nlohmann::ordered_json json_of(const effect::Settings& settings);

// The two parts of NAME=VALUE. Throws std::invalid_argument that names --set.
[[nodiscard]] std::pair<std::string, std::string> assignment_of(const std::string& text);

// Applies NAME=VALUE. The method and the radius also change other settings, so --method and --radius apply
// them. Throws std::invalid_argument.
void apply(effect::Settings& settings, const std::string& assignment);

// The settings of a preset by name, or of a file if the name ends with ".json": {"name", "description",
// "settings": {NAME: value, ...}}, lengths for a radius of 1. Settings that the file does not name are those
// of `tssao-paper`. Throws like preset_named() and base::read_file(); std::runtime_error with the file for
// another form, std::invalid_argument for unknown settings, values out of range, and a radius other than 1.
[[nodiscard]] effect::Settings preset_settings(const std::string& name_or_file);

// The settings of a candidate for a view: those of its preset and method, scaled to its radius or the view's,
// then what else it changes, then every --set in order. Throws std::invalid_argument for invalid names and
// values, and if there is no radius.
[[nodiscard]] effect::Settings settings_for(const RenderCandidate& candidate,
                                            const std::optional<double>& view_radius);

// The value of --size: "640x360", sides of `least` to `most` pixels. Throws std::invalid_argument otherwise.
inline constexpr std::uint32_t any_size = std::numeric_limits<std::uint32_t>::max();
[[nodiscard]] backend::Extent parse_size(const std::string& text, std::uint32_t least = 1,
                                         std::uint32_t most = any_size);

}  // namespace gloam::cli
