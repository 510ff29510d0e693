// SPDX-License-Identifier: MIT
#include "effect/study/variants.hpp"

#include <limits>

namespace gloam::effect {
namespace {

constexpr float never = 2.0F;    // a convergence that is never reached
constexpr float without = 1e6F;  // samples: a cap that is never reached

// The cap is the unit of convergence, so the thresholds are scaled to the same numbers of samples.
Settings uncapped(Settings settings) {
    const float part = settings.weight_max / without;
    settings.weight_max = without;
    settings.c_spatial *= part;
    settings.c_rot *= part;
    settings.c_adaptive *= part;
    return settings;
}

}  // namespace

std::vector<Variant> ablations_of(const Settings& full) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    std::vector<Variant> variants{{"full", "", full}};
    const auto off = [&](const char* name, const char* instead, const auto& change) {
        Settings settings = full;
        change(settings);
        variants.push_back({name, instead, settings});
    };
    off("disocclusion test (8)", "every surface is the same",
        [](Settings& s) { s.depth_tolerance = infinity; });
    off("neighbourhood (9)", "the history counts in full",
        [](Settings& s) { s.invalidation = Invalidation::none; });
    off("smooth invalidation by confidence", "at most 48 samples count", [](Settings& s) {
        s.invalidation = Invalidation::clamp;
        s.weight_small = 48.0F;
    });
    off("both smooth invalidations", "a changed neighbourhood starts afresh", [](Settings& s) {
        s.invalidation = Invalidation::clamp;
        s.weight_small = 0.0F;
    });
    off("adaptive k", "always k1", [](Settings& s) { s.c_spatial = never; });
    off("adaptive k, the other way", "always k2", [](Settings& s) { s.c_spatial = 0.0F; });
    off("filter", "none", [](Settings& s) { s.filter = Filter::none; });
    off("shrink", "always the full window", [](Settings& s) { s.c_adaptive = infinity; });
    off("trust in what has converged (10)", "at most that in the pixel itself",
        [](Settings& s) { s.filter_cap = 1.0F; });
    off("rotation switch", "always rotated", [](Settings& s) { s.c_rot = never; });
    off("rotation", "never rotated", [](Settings& s) { s.c_rot = 0.0F; });
    off("nearest index", "interpolated", [](Settings& s) { s.nearest_index = false; });
    off("validation of each tap", "bilinear where the nearest is valid",
        [](Settings& s) { s.taps = HistoryTaps::bilinear; });
    off("bilinear taps", "the nearest texel", [](Settings& s) { s.taps = HistoryTaps::nearest; });
    off("frame without a guard band", "10 % on each side, rendered, shaded and cropped",
        [](Settings& s) { s.guard = 0.1F; });
    variants.push_back({"weight cap", "all samples count alike", uncapped(full)});
    return variants;
}

}  // namespace gloam::effect
