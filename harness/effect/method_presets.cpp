// SPDX-License-Identifier: MIT
#include <utility>

#include "effect/internal/method_presets.hpp"
#include "effect/methods.hpp"

namespace gloam::effect {
namespace {

Settings configuration(const char* method, std::uint32_t samples) {
    Settings settings = with_method(Settings{}, method);
    settings.samples = samples;
    settings.samples_converged = samples;
    return settings;
}

// The comparative study's: each frame by itself, in its quality configuration without a blur.
Settings studied(Settings settings) {
    settings.history = false;
    settings.filter = Filter::none;
    return settings;
}

// In its performance configuration with its blur, one pixel wide at the least.
Settings blurred(Settings settings, int half_width = 2) {
    settings = studied(std::move(settings));
    settings.filter = Filter::geometry;
    settings.filter_half_width = half_width;
    return settings;
}

// With the SAO paper's blur, whose depth key reaches 300 m and falls to nothing in a 2000th of it.
Settings sao(std::uint32_t samples) {
    Settings settings = configuration("sao", samples);
    settings.filter = Filter::sao;
    settings.filter_half_width = 4;
    settings.filter_depth = 0.15F;
    return settings;
}

// The study's values at its radius of 10: sigma 2, bias 1, epsilon^2 1e-5.
Settings study_alchemy(std::uint32_t samples) {
    Settings settings = configuration("alchemy", samples);
    settings.intensity = 0.2F;
    settings.bias = 0.1F;
    settings.epsilon = 3.2e-4F;
    return settings;
}

Settings rays(const char* method, std::uint32_t count, std::uint32_t steps) {
    Settings settings = configuration(method, count * steps);
    settings.steps = steps;
    return settings;
}

Settings slices(const char* method, std::uint32_t count, std::uint32_t steps) {
    return rays(method, 2 * count, steps);
}

// Lengths of a figure of the ISSAO paper, with the radius they go with.
struct Figure {
    float radius;
    float phi;
    float psi;
    float lambda;
    float sigma_root;
};

Settings issao(const Figure& figure) {
    Settings settings = configuration("issao", 12);
    settings.intensity = figure.lambda * figure.phi / figure.radius;
    settings.bias = figure.psi / figure.radius;
    settings.epsilon = figure.sigma_root / figure.radius;
    settings.filter = Filter::bilateral;
    return settings;
}

}  // namespace

std::vector<Preset> method_presets() {
    return {
        {"crytek-performance", "the comparative study's: 24 samples, its blur, no history",
         blurred(configuration("crytek", 24))},
        {"crytek-quality", "the study's: 200 samples, no blur, no history",
         studied(configuration("crytek", 200))},
        {"filion-performance", "the study's: 15 samples, its blur, no history",
         blurred(configuration("filion", 15))},
        {"filion-quality", "the study's: 80 samples, no blur, no history",
         studied(configuration("filion", 80))},
        {"hbao-performance", "the study's: 8 directions of 6 steps, its blur, no history",
         blurred(slices("hbao_study", 4, 6))},
        {"hbao-quality", "the study's published shader: 8 directions of 6 steps, no blur, no history",
         studied(slices("hbao_study", 4, 6))},
        {"volumetric-performance",
         "the study's: pairs of lines, a blur of one pixel, no history; how many it does not print, 6 here",
         blurred(configuration("volumetric", 12), 1)},
        {"volumetric-quality", "the study's: 32 pairs of lines, no blur, no history",
         studied(configuration("volumetric", 64))},
        {"alchemy-performance",
         "the study's lengths and blur, no history; how many samples it does not print, 12 as in the Alchemy "
         "paper",
         blurred(study_alchemy(12))},
        {"alchemy-quality", "the study's: 64 samples, no blur, no history", studied(study_alchemy(64))},
        {"angle-performance", "the study's: 6 pairs, its blur, no history",
         blurred(configuration("angle", 12))},
        {"angle-quality", "the study's: 32 pairs, no blur, no history", studied(configuration("angle", 64))},
        {"sao-performance", "the SAO paper's 9 samples", sao(9)},
        {"sao-quality", "11 samples", sao(11)},
        {"poisson-performance", "Sourimant's least: 8 rays of 4 steps", rays("poisson", 8, 4)},
        {"poisson-quality", "and most: 24 rays, of 8 steps", rays("poisson", 24, 8)},
        {"aksoy_phaneuf-two", "Aksoy and Phaneuf's 32 taps, at two radii",
         configuration("aksoy_phaneuf_two", 32)},
        {"unreal-quality", "the engine's 6 mirrored directions of 3 steps", rays("unreal", 12, 3)},
        {"issao-figure3", "the ISSAO paper's figure 3: 12 samples",
         issao({1.75F, 0.40F, 0.022F, 1.06F, 0.0126491F})},
        {"issao-figure4", "its figure 4", issao({1.05F, 0.43F, 0.014F, 1.00F, 0.0137840F})},
        {"issao-figure5", "its figure 5", issao({2.20F, 0.55F, 0.018F, 1.00F, 0.0122474F})},
        {"gtao-performance", "1 slice of 2 steps to each side", slices("gtao", 1, 2)},
        {"gtao-quality", "9 slices of 3 steps to each side", slices("gtao", 9, 3)},
        {"bitmask-performance", "1 slice of 2 steps to each side", slices("bitmask", 1, 2)},
        {"bitmask-quality", "9 slices of 3 steps to each side", slices("bitmask", 9, 3)},
    };
}

}  // namespace gloam::effect
