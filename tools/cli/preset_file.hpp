// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "effect/settings.hpp"

namespace gloam::cli {

// A preset as a file: {"name", "description", "settings": {NAME: value, ...}}, lengths for a radius of 1.
// Settings that the file does not name have their defaults.
[[nodiscard]] std::string preset_json(const std::string& name, const std::string& description,
                                      const effect::Settings& settings);

// The settings of such a file's text. Throws std::runtime_error that names the file for text of another form,
// std::invalid_argument for an unknown setting, a value out of range, or a radius other than 1.
[[nodiscard]] effect::Settings preset_from(const std::string& file, std::string_view text);

// The settings of a preset by name, or of a file if the name ends with ".json". Throws like
// effect::preset_named(), read_text() and preset_from().
[[nodiscard]] effect::Settings preset_settings(const std::string& name_or_file);

}  // namespace gloam::cli
