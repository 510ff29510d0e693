// SPDX-License-Identifier: MIT
#include "effect/presets.hpp"

#include "effect/internal/named.hpp"
#include "effect/methods.hpp"

namespace gloam::effect {
namespace {

// Table 1 of the TSSAO paper, and the lengths ours, for a radius of 1: what Settings are by themselves.
Settings paper() {
    return {};
}

// A short memory: what the depth buffer can tell of a surface changes with the view, and a mean over 500
// samples shows what it told long ago. The filter stops at as many samples as in table 1, and what has just
// come into view it does not leave to neighbours that have converged (docs/temporal.md).
Settings moving() {
    Settings settings = paper();
    settings.samples_converged = 32;
    settings.weight_max = 128.0F;
    settings.c_rot = 2.0F;
    settings.c_adaptive = 0.78F;
    settings.filter_cap = 1.0F;
    return settings;
}

// Three points of the front of error against time over moving cameras (docs/benchmark.md). All leave the
// noise to the mean, which costs nothing, instead of a filter, which costs as much as several samples; and
// hold the history in half the bytes, which rounds far less than it lags.
Settings unfiltered(Settings settings, std::uint32_t samples) {
    settings.samples = samples;
    settings.samples_converged = samples;
    settings.filter = Filter::none;
    settings.precision = HistoryPrecision::packed;
    return settings;
}

// At the time of a single frame of one slice, more exact than one of nine (docs/temporal.md): of the
// estimators the nearest to the truth where the depth buffer hides most. Darker, it errs more where little is
// hidden.
Settings fast() {
    Settings settings = with_method(moving(), "alchemy");
    settings.intensity = 0.35F;
    return unfiltered(settings, 3);
}

// With more samples the paper's points are the more exact, once what is further in front than the radius no
// longer counts.
Settings balanced() {
    Settings settings = moving();
    settings.range = 1.0F;
    return unfiltered(settings, 8);
}

// A mean no longer than a frame: at so many samples lag is more error than noise.
Settings reference() {
    Settings settings = unfiltered(balanced(), 64);
    settings.weight_max = 64.0F;
    return settings;
}

}  // namespace

std::vector<Preset> presets() {
    std::vector<Preset> all{
        {"paper", "the TSSAO paper's table 1: 32 samples a frame, 500 in the mean", paper()},
        {"moving", "32 samples a frame, 128 in the mean: for cameras and objects that move", moving()},
        {"fast", "Alchemy's taps, 3 a frame, 128 in the mean, no filter: for the least time", fast()},
        {"balanced", "8 samples a frame, 128 in the mean, no filter", balanced()},
        {"reference", "64 samples a frame, 64 in the mean, no filter: for the least error", reference()}};
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
