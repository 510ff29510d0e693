// SPDX-License-Identifier: MIT
#include "effect/presets.hpp"

#include "effect/internal/method_presets.hpp"
#include "effect/internal/named.hpp"
#include "effect/methods.hpp"

namespace gloam::effect {
namespace {

// Table 1 of the TSSAO paper, and the lengths ours, for a radius of 1: what Settings are by themselves.
Settings paper() {
    return {};
}

Settings fast() {
    Settings settings = paper();
    settings.samples = 8;
    settings.samples_converged = 4;
    return settings;
}

Settings quality() {
    Settings settings = paper();
    settings.samples = 128;
    settings.samples_converged = 64;
    settings.weight_max = 1500.0F;
    return settings;
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

// At the time of a single frame of one slice, more exact than one of nine (docs/temporal.md): few samples,
// whose noise the mean over the frames takes away in place of a filter, of the estimator that stands near the
// truth where the depth buffer hides most. Darker than that, it costs error where little is hidden.
Settings lean() {
    Settings settings = with_method(moving(), "alchemy");
    settings.intensity = 0.35F;
    settings.samples = 3;
    settings.samples_converged = 3;
    settings.filter = Filter::none;
    return settings;
}

}  // namespace

std::vector<Preset> presets() {
    std::vector<Preset> all{
        {"paper", "the TSSAO paper's table 1: 32 samples a frame, 500 in the mean", paper()},
        {"fast", "8 samples a frame, 500 in the mean", fast()},
        {"moving", "32 samples a frame, 128 in the mean: for cameras and objects that move", moving()},
        {"lean", "3 taps a frame, 128 in the mean, no filter: for the least time", lean()},
        {"quality", "128 samples a frame, 1500 in the mean", quality()}};
    const std::vector<Preset> of_methods = method_presets();
    all.insert(all.end(), of_methods.begin(), of_methods.end());
    return all;
}

Preset preset_named(std::string_view name) {
    const std::vector<Preset> all = presets();
    return named(all, name, "preset");
}

}  // namespace gloam::effect
