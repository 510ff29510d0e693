// SPDX-License-Identifier: MIT
// gloam's own presets, and the names of all.
#include <algorithm>
#include <stdexcept>
#include <utility>

#include "effect/internal/method_families.hpp"
#include "effect/internal/named.hpp"
#include "effect/methods.hpp"

namespace gloam::effect {
namespace {

// The frame with this many slices, of `steps` taps to both sides. range, sharpness: of its history.
Settings frame_of(std::uint32_t slices, std::uint32_t steps, float range, float sharpness) {
    Settings settings;
    settings.passes = Passes::frame;
    settings.method = "sweep";
    settings.own.steps = steps;
    settings.samples = 2 * slices * steps;
    settings.history_range = range;
    settings.history_sharpness = sharpness;
    settings.output = OutputFormat::r8;
    return settings;
}

Settings half_size(Settings settings) {
    settings.resolution = Resolution::half;
    return settings;
}

// In full only where the occlusion at half size deviates so much within a tile.
Settings in_tiles(float mark, Settings settings) {
    settings.resolution = Resolution::tiles;
    settings.mark = mark;
    return settings;
}

std::vector<Preset> own_presets() {
    return {{"fast", "half the resolution, 1 slice of 6 steps to each side: for the least time",
             half_size(frame_of(1, 6, 0.15F, 0.3F))},
            {"balanced", "half the resolution, 2 slices of 8 steps to each side: the default",
             half_size(frame_of(2, 8, 0.08F, 0.9F))},
            {"quality", "2 slices of 8 steps to each side where half the resolution does not suffice",
             in_tiles(0.08F, frame_of(2, 8, 0.03F, 0.8F))},
            {"reference", "2 slices of 10 steps in more of these tiles: for the least error",
             in_tiles(0.04F, frame_of(2, 10, 0.03F, 0.8F))}};
}

struct Measured {
    std::string_view name;
    double error;
    double time;
    double tiles = 1.0;
};

// What one run of `gloam bench presets` printed: errors, which an H200 and llvmpipe have alike, and times on
// llvmpipe (LLVM 15.0.6), two cores. tiles: the mean of the perspective unseen views at 640 x 360, single
// frames.
constexpr Measured measured[] = {{"fast", 0.0539, 1.00},
                                 {"balanced", 0.0511, 1.28},
                                 {"quality", 0.0459, 1.84, 0.260},
                                 {"reference", 0.0450, 2.39, 0.351},
                                 {"tssao-paper", 0.0708, 4.85},
                                 {"study-crytek-performance", 0.1022, 4.85},
                                 {"study-crytek-quality", 0.0997, 32.47},
                                 {"study-filion-performance", 0.0726, 3.49},
                                 {"study-filion-quality", 0.0711, 12.98},
                                 {"study-alchemy-performance", 0.0921, 2.40},
                                 {"study-alchemy-quality", 0.0913, 7.15},
                                 {"sao-paper", 0.0855, 2.61},
                                 {"sao-code", 0.0852, 2.91},
                                 {"issao-figure3", 0.0983, 2.52},
                                 {"issao-figure4", 0.0846, 2.44},
                                 {"issao-figure5", 0.0966, 2.47},
                                 {"issao-figure4-attenuated", 0.0828, 2.90},
                                 {"issao-figure4-basic", 0.0798, 2.74},
                                 {"aksoy_phaneuf-two", 0.1069, 4.60},
                                 {"study-volumetric-performance", 0.1103, 2.21},
                                 {"study-volumetric-quality", 0.1111, 5.05},
                                 {"toy-story-3", 0.1118, 2.23},
                                 {"study-angle-performance", 0.0913, 3.51},
                                 {"study-angle-quality", 0.0916, 11.36},
                                 {"study-hbao-performance", 0.0614, 4.44},
                                 {"study-hbao-quality", 0.0609, 3.51},
                                 {"xegtao-low", 0.0989, 1.46},
                                 {"xegtao-medium", 0.0973, 2.33},
                                 {"xegtao-high", 0.0884, 3.05},
                                 {"xegtao-ultra", 0.0881, 5.86},
                                 {"sourimant-least", 0.1237, 13.62},
                                 {"sourimant-most", 0.1429, 46.65},
                                 {"unreal-quality", 0.1497, 4.37},
                                 {"loos-sloan-area", 0.1200, 2.27}};

std::vector<Preset> measured_presets() {
    std::vector<Preset> all = own_presets();
    for (Preset& preset : all) preset.published = false;
    for (const MethodInfo& method : methods()) {
        if (method.presets == nullptr) continue;
        const std::vector<Preset> published = method.presets(method);
        all.insert(all.end(), published.begin(), published.end());
    }
    for (Preset& preset : all) {
        const auto* row = std::ranges::find(measured, std::string_view(preset.name), &Measured::name);
        if (row == std::end(measured)) throw std::logic_error("preset " + preset.name + " was not measured");
        preset.error = row->error;
        preset.time = row->time;
        preset.tiles = row->tiles;
    }
    return all;
}

}  // namespace

const std::vector<Preset>& presets() {
    static const std::vector<Preset> all = measured_presets();
    return all;
}

std::string origin_of(const Preset& preset, const std::string& setting) {
    if (!preset.published && setting == "method") return "";
    const std::string_view temporal = "tssao-paper";
    const Preset& source =
        preset.published ? preset : *std::ranges::find(presets(), temporal, [](const Preset& one) {
            return std::string_view(one.name);
        });
    for (const auto& [name, symbol] : source.printed)
        if (name == setting) return preset.published ? symbol : symbol.substr(0, symbol.find(','));
    return preset.published ? "ours" : "";
}

Preset preset_named(std::string_view name) {
    return named(presets(), name, "preset");
}

}  // namespace gloam::effect
