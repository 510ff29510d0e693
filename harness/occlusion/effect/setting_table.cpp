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
constexpr double largest = 1e18;  // squares stay finite
constexpr SettingRange positive{.least = 1e-18, .most = largest, .above_least = true};
constexpr SettingRange not_negative{.most = largest};
constexpr SettingRange any_from_0{};

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
Setting number(const char* name, const char* unit, const char* meaning, Number Owner::* member,
               const SettingRange& range) {
    return {.name = name,
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

Setting flag(const char* name, const char* meaning, bool Settings::* member) {
    return {.name = name,
            .meaning = meaning,
            .get = [member](const Settings& s) { return SettingValue(s.*member); },
            .put = [member](Settings& s, const SettingValue& v) { s.*member = std::get<bool>(v); }};
}

// A setting with a name for each value, in the order of the enumeration.
template <class Enumeration>
Setting choice(const char* name, const char* meaning, Enumeration Settings::* member,
               const std::vector<std::string>& names) {
    return {
        .name = name,
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

Setting method() {
    Setting setting{.name = "method",
                    .meaning = "how the occlusion of a pixel is estimated",
                    .get = [](const Settings& s) { return SettingValue(s.method); },
                    .put = [](Settings& s, const SettingValue& v) { s.method = std::get<std::string>(v); }};
    for (const MethodInfo& info : methods()) setting.choices.push_back(info.name);
    return setting;
}

void add_estimator(std::vector<Setting>& table) {
    using S = Settings;
    table.push_back(choice("passes",
                           "study: TSSAO as printed, around any method; frame: the three for engines",
                           &S::passes, {"study", "frame"}));
    table.push_back(method());
    table.push_back(number("radius", "world units", "of influence", &S::radius, positive));
    table.push_back(number("bias", "world units", "differences below it are rounding, not occlusion",
                           &S::bias, not_negative));
    table.push_back(number("bias_depth", "",
                           "the bias is at least this share of the depth: 0.002 for depths from halves",
                           &S::bias_depth, {.most = 1.0}));
    table.push_back(number("range", "world units", "blockers further in front than this are other objects",
                           &MethodValues::range, positive));
    table.push_back(number("epsilon", "world units",
                           "distance at which a patch counts fully, or that keeps a quotient finite",
                           &MethodValues::epsilon, positive));
    table.push_back(number("intensity", "", "factor of the estimate, for methods that have one",
                           &MethodValues::intensity, not_negative));
    table.push_back(number("thickness", "world units",
                           "how far behind its front a surface blocks, for bitmasks",
                           &MethodValues::thickness, positive));
    table.push_back(number("angle_bias", "radians", "above the tangent plane, for horizons",
                           &MethodValues::angle_bias, {.most = 1.5707964}));
    table.push_back(number("mip_distance", "pixels",
                           "from which level 1 of the depth chain is read, for taps; 0: never",
                           &MethodValues::mip_distance, any_from_0));
    table.push_back(number("layers", "layers",
                           "of depth that samples see, for hemisphere, ssdo and dual_resolution",
                           &MethodValues::layers, whole(1, 1 + scene::most_further_layers)));
    table.push_back(number("steps", "taps",
                           "along each half of a slice, for horizons; resolutions, for mssao",
                           &MethodValues::steps, whole(1, 64)));
    table.push_back(number("disagreement", "of the occlusion",
                           "of neighbours at half the resolution, beyond which a pixel is sampled in full",
                           &MethodValues::disagreement, {.most = 1.0}));
    table.push_back(
        number("feature_thickness", "widths",
               "of what stands in front of the rest, for sweeps; 1e18: solid behind every surface",
               &MethodValues::feature_thickness, not_negative));
}

void add_samples(std::vector<Setting>& table) {
    using S = Settings;
    table.push_back(number("samples", "samples", "k_1: for each pixel that has not converged, in each frame",
                           &S::samples, whole(1, most_samples)));
    table.push_back(number("samples_converged", "samples", "k_2: for each pixel that has",
                           &S::samples_converged, whole(1, most_samples)));
    table.push_back(number("samples_distance", "world units of depth",
                           "of the far plane: fewer samples the further away; 0: as many everywhere",
                           &S::samples_distance, any_from_0));
    table.push_back(number("samples_radius", "pixels",
                           "fewer samples where the projected radius is smaller; 0: as many everywhere",
                           &S::samples_radius, any_from_0));
    table.push_back(number("samples_least", "samples", "of samples_distance and samples_radius, at least",
                           &S::samples_least, whole(0, most_samples)));
    table.push_back(number("radius_cap", "pixels", "the projected radius is at most that large",
                           &S::radius_cap, positive));
    table.push_back(flag("reject_taps",
                         "points, taps and slices leave out what is further in front than range",
                         &S::reject_taps));
    table.push_back(number("smoothing", "of a frame",
                           "in an exponential mean over frames; 0: the mean of all samples", &S::smoothing,
                           {.most = 1.0}));
    table.push_back(number("c_spatial", "", "convergence from which a pixel takes k_2; above 1: never",
                           &S::c_spatial, any_from_0));
    table.push_back(number("table_size", "samples", "after which the sequence starts over", &S::table_size,
                           whole(1, 1U << 24U)));
    table.push_back(number("weight_max", "samples", "in the mean at most", &S::weight_max,
                           {.least = 1.0, .most = 8'388'608.0}));
    table.push_back(number("c_rot", "",
                           "kernels are rotated by pixel below this convergence; 0: never, above 1: always",
                           &S::c_rot, any_from_0));
    table.push_back(choice("rotation", "of a pixel's kernel: by a hash, or by its place on a lattice",
                           &S::rotation, {"hash", "lattice"}));
    table.push_back(number(
        "filter_cap", "", "the filter's neighbours weigh at most this many times the pixel's own convergence",
        &S::filter_cap, SettingRange{.least = 1, .most = largest}));
    table.push_back(number("c_adaptive", "", "the filter leaves pixels of this convergence as they are",
                           &S::c_adaptive, any_from_0));
}

void add_history(std::vector<Setting>& table) {
    using S = Settings;
    table.push_back(number("depth_tolerance", "", "relative: another surface beyond it; inf: no test",
                           &S::depth_tolerance, {.above_least = true}));
    table.push_back(choice("taps", "texels of the frame before that the history comes from", &S::taps,
                           {"nearest", "bilinear", "validated"}));
    table.push_back(flag(
        "history", "off: each frame stands by itself, with the first samples of the sequence", &S::history));
    table.push_back(choice("invalidation", "of a history whose neighbourhood has changed", &S::invalidation,
                           {"none", "clamp", "confidence"}));
    table.push_back(number("change_tolerance", "world units",
                           "change of a distance that is taken for rounding", &S::change_tolerance,
                           positive));
    table.push_back(
        number("weight_small", "samples", "that a history keeps by clamping", &S::weight_small, any_from_0));
    table.push_back(number("confidence_factor", "per radius", "S: how fast a change takes the confidence",
                           &S::confidence_factor, not_negative));
    table.push_back(number("history_range", "of the occlusion",
                           "of the frame: how far the mean may be from that of the last frames",
                           &S::history_range, {.most = 1.0}));
    table.push_back(number("history_sharpness", "of the neighbours' weights",
                           "of the frame: the part that a long mean leaves out of a new frame",
                           &S::history_sharpness, {.most = 1.0}));
}

Setting filter() {
    Setting setting = choice("filter", "after the estimate, for display", &Settings::filter,
                             {"none", "convergence", "geometry", "bilateral", "sao"});
    setting.synonyms = {{"on", "convergence"}, {"off", "none"}};
    return setting;
}

void add_output(std::vector<Setting>& table) {
    using S = Settings;
    table.push_back(
        choice("output", "format of the displayed occlusion", &S::output, {"r32f", "r16f", "r8"}));
    table.push_back(choice("resolution", "of the frame's sweep: the view's, or half of it, joined by depth",
                           &S::resolution, {"full", "half"}));
    table.push_back(filter());
    table.push_back(number("filter_half_width", "taps",
                           "on each side: 2 is 5 x 5; bilateral at most 16, sao at most 4",
                           &S::filter_half_width, whole(0, 64)));
    table.push_back(number("filter_sigma", "of the window's width",
                           "standard deviation of the Gaussian: convergence, bilateral", &S::filter_sigma,
                           positive));
    table.push_back(number("filter_depth", "world units",
                           "difference of depth that sets a neighbour apart: geometry, bilateral, sao",
                           &S::filter_depth, positive));
    table.push_back(number("remap_a", "", "what is shown is (b (v + a))^c of the visibility v", &S::remap_a,
                           {.least = -1.0, .most = 1.0}));
    table.push_back(number("remap_b", "", "see remap_a", &S::remap_b, not_negative));
    table.push_back(number("remap_c", "", "see remap_a", &S::remap_c, not_negative));
    table.push_back(number("least_radius", "pixels",
                           "below this projected radius the occlusion is 0 without a sample; 0: never",
                           &S::least_radius, any_from_0));
    table.push_back(number("guard", "of the frame", "guard band on each side", &S::guard, {.most = 0.5}));
    table.push_back(flag("guard_history", "the band is sampled too: what moves in from it has a history",
                         &S::guard_history));
}

SettingValue value_of(const Setting& setting, std::string_view text) {
    const SettingValue kind = setting.get(Settings{});
    if (std::holds_alternative<bool>(kind) && (text == "on" || text == "off")) return text == "on";
    if (std::holds_alternative<std::string>(kind)) {
        const auto synonym = std::ranges::find(setting.synonyms, text, [](const auto& s) { return s.first; });
        return synonym == setting.synonyms.end() ? std::string(text) : synonym->second;
    }
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
        for (const auto add : {add_estimator, add_samples, add_history, add_output}) add(all);
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
