// SPDX-License-Identifier: MIT
#include "effect/methods.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "backend/sampled.hpp"
#include "effect/internal/method_families.hpp"
#include "effect/internal/named.hpp"

namespace gloam::effect {

const std::vector<MethodInfo>& methods() {
    static const std::vector<MethodInfo> all = [] {
        std::vector<MethodInfo> methods;
        for (const auto& family : {point_methods(), tap_methods(), volumetric_methods(), slice_methods(),
                                   ray_methods(), surface_methods()})
            methods.insert(methods.end(), family.begin(), family.end());
        return methods;
    }();
    return all;
}

const MethodInfo& method_named(std::string_view name) {
    return named(methods(), name, "method");
}

Settings with_method(Settings settings, std::string_view name) {
    const MethodInfo& info = method_named(name);
    if (settings.passes == Passes::frame) settings = with_radius(Settings{}, settings.radius);
    if (settings.method != info.name) settings.own = {};
    settings.method = info.name;
    if (info.adapt != nullptr) info.adapt(settings);
    return settings;
}

std::uint32_t unit_of(const MethodInfo& method, std::uint32_t steps) {
    const std::uint32_t taps = std::max(steps, 1U);
    // In the order of SampleUnit.
    return backend::named(std::array{1U, 2U, 4U, taps, 2 * taps}, method.unit);
}

std::uint32_t samples_taken(const MethodInfo& method, std::uint32_t count, std::uint32_t steps) {
    if (count == 0) return 0;
    const std::uint32_t unit = unit_of(method, steps);
    const std::uint32_t asked = method.unit == SampleUnit::pair ? count + count % 2 : count;
    return std::max(asked / unit, 1U) * unit;
}

std::string file_of(const MethodInfo& method) {
    return fmt::format("gloam/methods/{}.glsl", method.family.empty() ? method.name : method.family);
}

std::string setting_of(const MethodMember& member) {
    if (!member.constant.empty()) return {};
    return member.setting.empty() ? member.name : member.setting;
}

bool reads(const MethodInfo& method, std::string_view setting) {
    return std::ranges::find(method.members, setting, setting_of) != method.members.end();
}

std::string call_of(const MethodInfo& method) {
    const std::string call = fmt::format("gloam_{}(position, normal, camera, kernel", method.name);
    if (method.own_settings.empty()) return call + ")";
    std::vector<std::string> members;
    for (const MethodMember& member : method.members)
        members.push_back(member.constant.empty() ? "values." + setting_of(member) : member.constant);
    return fmt::format("{}, {}({}))", call, method.own_settings, fmt::join(members, ", "));
}

Settings configuration(const MethodInfo& method, std::uint32_t samples) {
    Settings settings;
    settings.method = method.name;
    if (method.adapt != nullptr) method.adapt(settings);
    settings.samples = samples;
    settings.samples_converged = samples;
    return settings;
}

Settings studied(Settings settings) {
    settings.history = false;
    settings.filter = Filter::none;
    return settings;
}

Settings blurred(Settings settings, int half_width) {
    settings = studied(std::move(settings));
    settings.filter = Filter::geometry;
    settings.filter_half_width = half_width;
    return settings;
}

Printed printed_by_study(const Printed& more) {
    Printed all{{"method", "CS"},
                {"history", "none in the study"},
                {"filter", "its blur (CS-BLUR); none in the quality configuration"}};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

Settings rays(const MethodInfo& method, std::uint32_t count, std::uint32_t steps) {
    Settings settings = configuration(method, count * steps);
    settings.own.steps = steps;
    return settings;
}

Settings slices(const MethodInfo& method, std::uint32_t count, std::uint32_t steps) {
    return rays(method, 2 * count, steps);
}

std::string to_string(Measure measure) {
    return backend::named(std::array{"cosine-weighted", "uniform", "volume", "shape"}, measure);
}

}  // namespace gloam::effect
