// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <type_traits>

#include "base/number.hpp"
#include "effect/internal/named.hpp"
#include "effect/methods.hpp"
#include "effect/settings.hpp"
#include "numeric/numbers.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

namespace {

using numeric::infinity;
using enum ReadBy;
constexpr double largest = 1e18;  // squares stay finite
constexpr SettingRange positive{.least = 1e-18, .most = largest, .above_least = true};
constexpr SettingRange not_negative{.most = largest};
constexpr SettingRange any_from_0{};
constexpr SettingRange above_0{.above_least = true};

constexpr SettingRange from_to(double least, double most) {
    return {.least = least, .most = most};
}
constexpr SettingRange up_to(double most) {
    return {.most = most};
}
constexpr SettingRange whole(double least, double most) {
    return {.least = least, .most = most, .whole = true};
}

// The struct that has a setting: the settings, or what is a method's own.
template <class Owner, class Any>
auto& part_of(Any& settings) {
    if constexpr (std::is_same_v<Owner, MethodValues>)
        return settings.own;
    else
        return settings;
}

template <class Number, class Owner>
Setting number(const char* name, ReadBy by, const char* unit, const char* meaning, Number Owner::* member,
               const SettingRange& range) {
    return {.name = name,
            .read_by = by,
            .unit = unit,
            .meaning = meaning,
            .range = range,
            .get =
                [member](const Settings& s) {
                    return SettingValue(static_cast<double>(part_of<Owner>(s).*member));
                },
            .put =
                [member](Settings& s, const SettingValue& v) {
                    part_of<Owner>(s).*member = static_cast<Number>(std::get<double>(v));
                }};
}

Setting flag(const char* name, ReadBy by, const char* meaning, bool Settings::* member) {
    return {.name = name,
            .read_by = by,
            .meaning = meaning,
            .get = [member](const Settings& s) { return SettingValue(s.*member); },
            .put = [member](Settings& s, const SettingValue& v) { s.*member = std::get<bool>(v); }};
}

// A setting with a name for each value, in the order of the enumeration.
template <class Enumeration>
Setting choice(const char* name, ReadBy by, const char* meaning, Enumeration Settings::* member,
               const std::vector<std::string>& names) {
    return {
        .name = name,
        .read_by = by,
        .meaning = meaning,
        .choices = names,
        .get = [member, names](
                   const Settings& s) { return SettingValue(names.at(static_cast<std::size_t>(s.*member))); },
        .put =
            [member, names](Settings& s, const SettingValue& v) {
                const auto found = std::ranges::find(names, std::get<std::string>(v));
                s.*member = static_cast<Enumeration>(found - names.begin());
            }};
}

Setting method(ReadBy by, const char* meaning) {
    Setting setting{.name = "method",
                    .read_by = by,
                    .meaning = meaning,
                    .get = [](const Settings& s) { return SettingValue(s.method); },
                    .put = [](Settings& s, const SettingValue& v) { s.method = std::get<std::string>(v); }};
    for (const MethodInfo& info : methods()) setting.choices.push_back(info.name);
    return setting;
}

SettingValue value_of(const Setting& setting, std::string_view text) {
    const SettingValue kind = setting.get(Settings{});
    if (std::holds_alternative<bool>(kind) && (text == "on" || text == "off")) return text == "on";
    if (setting.name == "filter" && (text == "on" || text == "off"))
        return text == "on" ? "convergence" : "none";
    if (std::holds_alternative<std::string>(kind)) return std::string(text);
    const auto number = base::number_from<double>(text);
    if (std::holds_alternative<double>(kind) && number) return *number;
    throw std::invalid_argument(
        fmt::format("{} \"{}\": expected {}", setting.name, text, expected_of(setting)));
}

bool allowed(const Setting& setting, const SettingValue& value) {
    if (const auto* name = std::get_if<std::string>(&value))
        return std::ranges::find(setting.choices, *name) != setting.choices.end();
    const auto* number = std::get_if<double>(&value);
    if (number == nullptr) return true;
    const SettingRange& range = setting.range;
    const bool enough = range.above_least ? *number > range.least : *number >= range.least;  // false for NaN
    return enough && *number <= range.most && (!range.whole || *number == std::floor(*number));
}

}  // namespace

const std::vector<Setting>& setting_table() {
    static const std::vector<Setting> table = [] {
        std::vector<Setting> all;
#define CHOICE(type, name, value, by, meaning, ...) \
    all.push_back(choice(#name, by, meaning, &Settings::name, {__VA_ARGS__}));
#define FLAG(name, value, by, meaning) all.push_back(flag(#name, by, meaning, &Settings::name));
#define METHOD(name, value, by, meaning) all.push_back(method(by, meaning));
#define NUMBER(type, name, value, by, unit, range, meaning) \
    all.push_back(number(#name, by, unit, meaning, &Settings::name, range));
#define OWN(type, name, value, by, unit, range, meaning) \
    all.push_back(number(#name, by, unit, meaning, &MethodValues::name, range));
#include "effect/setting_list.inc"
        return all;
    }();
    return table;
}

const Setting& setting_named(std::string_view name) {
    return named(setting_table(), name, "setting");
}

std::string expected_of(const Setting& setting) {
    if (!setting.choices.empty()) {
        std::string names;
        for (const std::string& name : setting.choices) {
            const bool last = name == setting.choices.back();
            names += (names.empty() ? "" : last ? " or " : ", ") + name;
        }
        return names;
    }
    if (std::holds_alternative<bool>(setting.get(Settings{}))) return "on or off";
    const SettingRange& range = setting.range;
    const char* kind = range.whole ? "a whole number, " : "";
    if (range.most == infinity)
        return range.above_least ? fmt::format("more than {:g}", range.least)
                                 : fmt::format("{:g} or more", range.least);
    if (range.above_least) return fmt::format("more than {:g}, at most {:g}", range.least, range.most);
    return fmt::format("{}{} to {}", kind, range.least, range.most);
}

void check(const Setting& setting, const SettingValue& value) {
    if (allowed(setting, value)) return;
    throw std::invalid_argument(
        fmt::format("{} {}: expected {}", setting.name, text_of(value), expected_of(setting)));
}

std::string text_of(const SettingValue& value) {
    if (const auto* on = std::get_if<bool>(&value)) return *on ? "on" : "off";
    if (const auto* number = std::get_if<double>(&value)) {
        // The shortest text that reads back as the same float; integers in full.
        const bool count = *number == std::floor(*number) && std::abs(*number) < 1e9;
        return count ? fmt::format("{:.0f}", *number) : fmt::format("{}", static_cast<float>(*number));
    }
    return std::get<std::string>(value);
}

void set(Settings& settings, std::string_view name, std::string_view text) {
    const Setting& setting = setting_named(name);
    const SettingValue value = value_of(setting, text);
    check(setting, value);
    setting.put(settings, value);
}

}  // namespace gloam::effect
