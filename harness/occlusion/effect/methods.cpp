// SPDX-License-Identifier: MIT
#include "effect/methods.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "effect/internal/method_families.hpp"
#include "effect/internal/named.hpp"

namespace gloam::effect {

const std::vector<MethodInfo>& methods() {
    static const std::vector<MethodInfo> all = [] {
        std::vector<MethodInfo> methods;
        for (const auto& family : {point_methods(), tap_methods(), pair_methods(), slice_methods(),
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
    settings.method = info.name;
    if (info.adapt != nullptr) info.adapt(settings);
    return settings;
}

std::uint32_t unit_of(const MethodInfo& method, std::uint32_t steps) {
    const std::uint32_t taps = std::max(steps, 1U);
    switch (method.unit) {
        case SampleUnit::one:
            return 1;
        case SampleUnit::pair:
            return 2;
        case SampleUnit::cross:
            return 4;
        case SampleUnit::ray:
            return taps;
        case SampleUnit::slice:
            return 2 * taps;
    }
    throw std::invalid_argument("a unit of samples without a size");
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

Settings rays(const MethodInfo& method, std::uint32_t count, std::uint32_t steps) {
    Settings settings = configuration(method, count * steps);
    settings.own.steps = steps;
    return settings;
}

Settings slices(const MethodInfo& method, std::uint32_t count, std::uint32_t steps) {
    return rays(method, 2 * count, steps);
}

std::string to_string(Measure measure) {
    switch (measure) {
        case Measure::cosine:
            return "cosine-weighted";
        case Measure::uniform:
            return "uniform";
        case Measure::volume:
            return "volume";
        case Measure::shape:
            return "shape";
    }
    throw std::invalid_argument("a measure without a name");
}

namespace {

// Table 1 of the TSSAO paper, with our lengths for a radius of 1: the defaults of Settings.
Settings paper() {
    return {};
}

// A short memory: what the depth buffer shows of a surface changes with the view, and a mean over 500 samples
// lags behind. The filter stops at as many samples as in table 1. Pixels that have just come into view are
// not dominated by converged neighbours (docs/measurements.md).
Settings moving() {
    Settings settings = paper();
    settings.samples_converged = 32;
    settings.weight_max = 128.0F;
    settings.c_rot = 2.0F;
    settings.c_adaptive = 0.78F;
    settings.filter_cap = 1.0F;
    return settings;
}

// Three points on the front of error against time over moving cameras (docs/measurements.md). All reduce
// noise by the mean, which is free. All hold the history in half the bytes: its rounding error is far smaller
// than its lag.
Settings packed(Settings settings, std::uint32_t samples) {
    settings.samples = samples;
    settings.samples_converged = samples;
    settings.precision = HistoryPrecision::packed;
    return settings;
}

// Pixels with few samples are filtered in the first frames after a cut. Later the filter would change what
// has just come into view, and cost as much as several samples everywhere (docs/measurements.md).
Settings filtered_at_first(Settings settings) {
    settings.filter = Filter::convergence;
    settings.c_adaptive = 0.2F;
    settings.filter_frames = 8.0F;
    return settings;
}

// More exact than a single frame of nine slices, in less time (docs/measurements.md).
// Of all estimators this one is nearest to the truth where the depth buffer hides most. A larger intensity
// has larger errors where little is hidden.
Settings fast() {
    Settings settings = with_method(moving(), "alchemy");
    settings.own.intensity = 0.35F;
    return filtered_at_first(packed(settings, 3));
}

// With more samples the paper's points are more exact, if blockers further in front than the radius do not
// count.
Settings balanced() {
    Settings settings = moving();
    settings.own.range = 1.0F;
    return filtered_at_first(packed(settings, 8));
}

// Four slices of 12 steps to each side, in a mean over two frames: with so many samples, lag causes more
// error than noise.
Settings reference() {
    Settings settings = packed(with_method(moving(), "sweep"), 96);
    settings.filter = Filter::none;
    settings.own.steps = 12;
    settings.weight_max = 192.0F;
    return settings;
}

}  // namespace

std::vector<Preset> presets() {
    std::vector<Preset> all{
        {"paper", "the TSSAO paper's table 1: 32 samples a frame, 500 in the mean", paper()},
        {"moving", "32 samples a frame, 128 in the mean: for cameras and objects that move", moving()},
        {"fast",
         "Alchemy's taps, 3 a frame, 128 in the mean, filtered in the first 8 frames: for the least time",
         fast()},
        {"balanced", "8 samples a frame, 128 in the mean, filtered in the first 8 frames", balanced()},
        {"reference",
         "sweep, 4 slices of 12 steps to each side, a frame; 192 samples in the mean, no filter: for the "
         "least error",
         reference()}};
    for (const MethodInfo& method : methods()) {
        if (method.presets == nullptr) continue;
        const std::vector<Preset> published = method.presets(method);
        all.insert(all.end(), published.begin(), published.end());
    }
    return all;
}

Preset preset_named(std::string_view name) {
    const std::vector<Preset> all = presets();
    return named(all, name, "preset");
}

}  // namespace gloam::effect
