// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "effect/settings.hpp"

namespace gloam::effect {

// The value of a setting: a switch, a number, or one of several names.
using SettingValue = std::variant<bool, double, std::string>;

// The range of a number.
struct SettingRange {
    double least = 0.0;
    double most = std::numeric_limits<double>::infinity();
    bool above_least = false;  // `least` itself is excluded
    bool whole = false;
};

// One parameter of the effect. All code that reads, writes, checks, lists or prints settings uses the table
// of them. A new member of Settings therefore needs one line in the table.
struct Setting {
    std::string name;     // of the member
    std::string unit;     // "world units", "pixels", ...; empty: none. World units scale with the radius
    std::string meaning;  // in a few words
    SettingRange range;   // of a number
    std::vector<std::string> choices;                           // names, if its value is a name
    std::vector<std::pair<std::string, std::string>> synonyms;  // that set() reads, and the choice they mean
    std::function<SettingValue(const Settings&)> get;
    std::function<void(Settings&, const SettingValue&)> put;  // sets a value that check() accepts
};

// Every member of Settings, in its order.
[[nodiscard]] const std::vector<Setting>& setting_table();

// The setting with this name. Throws std::invalid_argument that lists the names.
[[nodiscard]] const Setting& setting_named(std::string_view name);

// The allowed values as text: "1 to 2048", "on or off", "nearest, bilinear or validated".
[[nodiscard]] std::string expected_of(const Setting& setting);

// Throws std::invalid_argument that names the setting, the value and what was expected. NaN is outside every
// range.
void check(const Setting& setting, const SettingValue& value);

// The value as text that set() reads: "on", "off", a number or a name.
[[nodiscard]] std::string text_of(const SettingValue& value);

// Changes the setting with this name. Throws like setting_named() and check(), and for text that is not a
// value.
void set(Settings& settings, std::string_view name, std::string_view text);

}  // namespace gloam::effect
