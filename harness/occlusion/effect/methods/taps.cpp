// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "effect/internal/method_families.hpp"

namespace gloam::effect {
namespace {

using enum Measure;

// An intensity with which the result is close to the occlusion; the published values are presets.
void adapt_alchemy(Settings& s) {
    s.own.intensity = 0.4F;
    s.bias = 0.005F;
    s.own.epsilon = 3.2e-4F;
}

// The paper's lengths, at its radius of 1 m. Its intensity of 1 is too dark for one radius, so this one is
// lower.
void adapt_sao(Settings& s) {
    s.own.intensity = 0.3F;
    s.bias = 0.01F;
    s.own.epsilon = 0.1F;
    s.own.mip_distance = 16.0F;
}

// The values of the paper's figure 3: radius 1.75, phi 0.4, psi 0.022, lambda 1.06, sigma 0.00016.
void adapt_issao(Settings& s) {
    s.own.intensity = 1.06F * 0.4F / 1.75F;
    s.bias = 0.022F / 1.75F;
    s.own.epsilon = 0.0126491F / 1.75F;
}

// GLOAM_LAST_TAP_LEVEL of gloam/sampling/depth_mip.glsl.
constexpr std::uint32_t last_tap_level = 5;

// The image with the layout of gloam/methods/sao_chain.glsl.
Preparation depth_chain(const Settings&, backend::Extent view) {
    const auto level = [view](std::uint32_t l) {
        return backend::Extent{std::max(view.width >> l, 1U), std::max(view.height >> l, 1U)};
    };
    std::uint32_t column = 0;
    for (std::uint32_t l = 2; l <= last_tap_level; ++l) column += level(l).height;
    return {.image = {level(1).width + level(2).width, std::max(level(1).height, column)},
            .format = backend::vulkan::Format::r32f,
            .passes = {{"depth_chain", "depth_chain.comp", level(1)}}};
}

// Adds the SAO paper's blur. Its weight falls to 0 at a 2000th of the depth key's range of 300 m.
Settings with_sao_blur(Settings settings) {
    settings.history = false;
    settings.filter = Filter::sao;
    settings.filter_half_width = 4;
    settings.filter_depth = 0.15F;
    return settings;
}

std::vector<Preset> sao_presets(const MethodInfo& method) {
    const Printed shader{{"method", "A of the shader"},
                         {"samples", "s"},
                         {"samples_converged", "s"},
                         {"bias", "beta"},
                         {"epsilon", "the root of epsilon"},
                         {"mip_distance", "2^(q + 1), log q = 3"},
                         {"rotation", "10 (3 x XOR (y + x y))"},
                         {"history", "none in the source"},
                         {"filter", "its blur"},
                         {"filter_half_width", "R"},
                         {"filter_depth", "edge sharpness"}};
    return {{"sao-paper", "the SAO paper's 9 samples and blur, no history; its intensity is ours",
             with_sao_blur(configuration(method, 9)), shader},
            {"sao-code", "the 11 samples of its published shader", with_sao_blur(configuration(method, 11)),
             shader}};
}

// The study's values at its radius of 10: sigma 2, bias 1, epsilon^2 1e-5.
Settings study_alchemy(const MethodInfo& method, std::uint32_t samples) {
    Settings settings = configuration(method, samples);
    settings.own.intensity = 0.2F;
    settings.bias = 0.1F;
    settings.own.epsilon = 3.2e-4F;
    return settings;
}

std::vector<Preset> alchemy_presets(const MethodInfo& method) {
    const Printed lengths{{"intensity", "sigma / R, of the published shader"},
                          {"bias", "beta / R, of the published shader"},
                          {"epsilon", "the root of epsilon / R, of the published shader"}};
    Printed with_samples = lengths;
    with_samples.insert(with_samples.end(), {{"samples", "of the published shader, not in print"},
                                             {"samples_converged", "of the published shader, not in print"}});
    return {{"study-alchemy-performance",
             "the study's lengths and blur, no history; the 12 samples are ours, those of the Alchemy paper",
             blurred(study_alchemy(method, 12)), printed_by_study(lengths)},
            {"study-alchemy-quality", "the study's: 64 samples as in its shader, no blur, no history",
             studied(study_alchemy(method, 64)), printed_by_study(with_samples)}};
}

// Lengths in a figure of the ISSAO paper, and the radius for which they are given.
struct Figure {
    float radius;
    float phi;
    float psi;
    float lambda;
    float sigma_root;
};

Settings of_figure(const MethodInfo& method, const Figure& figure) {
    Settings settings = configuration(method, 12);
    settings.own.intensity = figure.lambda * figure.phi / figure.radius;
    settings.bias = figure.psi / figure.radius;
    settings.own.epsilon = figure.sigma_root / figure.radius;
    settings.history = false;
    settings.filter = Filter::bilateral;
    // Radii are uniform: if there are more taps than the radius has pixels, some taps read the same pixel.
    settings.samples_radius = 12.0F;
    return settings;
}

// With the symbols of the equation by which the figure is drawn. samples: of their number.
Printed of_equation(const char* equation, const char* samples, Printed symbols = {}) {
    symbols.insert(symbols.end(), {{"method", equation},
                                   {"samples", samples},
                                   {"samples_converged", samples},
                                   {"samples_radius", "fewer samples far away, in prose"},
                                   {"history", "none in the paper"},
                                   {"filter", "eq 7"}});
    return symbols;
}

Printed by_eq_6(const char* samples) {
    return of_equation(
        "eq 6", samples,
        {{"intensity", "lambda phi / R"}, {"bias", "psi / R"}, {"epsilon", "the root of sigma / R"}});
}

constexpr Figure figure4{1.05F, 0.43F, 0.014F, 1.00F, 0.0137840F};

std::vector<Preset> issao_presets(const MethodInfo& method) {
    return {
        {"issao-figure3", "the ISSAO paper's figure 3: 12 samples, fewer where the radius is below 12 pixels",
         of_figure(method, {1.75F, 0.40F, 0.022F, 1.06F, 0.0126491F}), by_eq_6("s")},
        {"issao-figure4", "its figure 4, by eq. 6", of_figure(method, figure4), by_eq_6("s")},
        {"issao-figure5", "its figure 5; the number of samples is ours, that of the other figures",
         of_figure(method, {2.20F, 0.55F, 0.018F, 1.00F, 0.0122474F}), by_eq_6("ours")}};
}

std::vector<Preset> basic_presets(const MethodInfo& method) {
    Settings settings = of_figure(method, figure4);
    settings.own.intensity = 1.0F;  // eq. 3 has none
    return {{"issao-figure4-basic", "its figure 4 on the left, by eq. 3", settings,
             of_equation("eq 3", "12 in the figure")}};
}

std::vector<Preset> attenuated_presets(const MethodInfo& method) {
    return {{"issao-figure4-attenuated", "its figure 4 on the right, by eq. 4", of_figure(method, figure4),
             of_equation("eq 4", "12 in the figure", {{"intensity", "phi / R, of eq 5"}})}};
}

std::vector<Preset> two_radii_presets(const MethodInfo& method) {
    return {{"aksoy_phaneuf-two",
             "Aksoy and Phaneuf's 32 taps, at two radii, no history; the blur is ours",
             blurred(configuration(method, 32)),
             {{"method", "at two radii"},
              {"samples", "taps"},
              {"samples_converged", "taps"},
              {"history", "none in the source"}}}};
}

}  // namespace

std::vector<MethodInfo> tap_methods() {
    return {
        {.name = "disc",
         .description = "how concave the surface is, by surface points under a disc (TSSAO-12, TSSAO-13)",
         .measure = shape,
         .falloff = "none",
         .own_settings = "GloamDisc",
         .members = {{"epsilon"}}},
        {.name = "alchemy",
         .description = "surface points under a disc (McGuire et al. 2011)",
         .falloff = "alchemy",
         .own_settings = "GloamAlchemy",
         .members = {{"epsilon"}, {"intensity"}},
         .adapt = adapt_alchemy,
         .presets = alchemy_presets},
        {.name = "sao",
         .description = "surface points on a spiral, far ones from a depth chain (McGuire et al. 2012)",
         .falloff = "cubic",
         .own_settings = "GloamSao",
         .members = {{"epsilon"}, {"intensity"}, {"mip_distance"}},
         .adapt = adapt_sao,
         .presets = sao_presets},
        {.name = "sao_chain",
         .description = "sao with its depth chain in an image: the same result (McGuire et al. 2012)",
         .falloff = "cubic",
         .own_settings = "GloamSao",
         .members = {{"epsilon"}, {"intensity"}, {"mip_distance"}},
         .adapt = adapt_sao,
         .prepare = depth_chain},
        {.name = "issao",
         .description = "surface points under the covering circle, dense near the pixel (ISSAO)",
         .falloff = "alchemy",
         .own_settings = "GloamIssao",
         .members = {{"epsilon"}, {"intensity"}, {.name = "distinct", .constant = "GLOAM_EVERY_TAP"}},
         .adapt = adapt_issao},
        {.name = "issao_distinct",
         .family = "issao",
         .description = "issao, in which taps that fall into the same pixel count once",
         .falloff = "alchemy",
         .own_settings = "GloamIssao",
         .members = {{"epsilon"}, {"intensity"}, {.name = "distinct", .constant = "GLOAM_DISTINCT_TAPS"}},
         .adapt = adapt_issao,
         .presets = issao_presets},
        {.name = "issao_attenuated",
         .family = "issao",
         .description = "the taps of issao by its eq. 4: cosines, attenuated by distance",
         .falloff = "alchemy",
         .own_settings = "GloamIssaoAttenuated",
         .members = {{"epsilon"}, {"intensity"}},
         .adapt = adapt_issao,
         .presets = attenuated_presets},
        {.name = "issao_basic",
         .family = "issao",
         .description = "the taps of issao by its eq. 3: cosines of all within the radius",
         .falloff = "none up to the radius",
         .adapt = [](Settings& s) { s.bias = 0.022F / 1.75F; },
         .presets = basic_presets},
        {.name = "aksoy_phaneuf",
         .description = "surface points under a disc by their distance (Aksoy and Phaneuf 2011)",
         .measure = shape,
         .falloff = "linear"},
        {.name = "aksoy_phaneuf_two",
         .family = "aksoy_phaneuf",
         .description = "aksoy_phaneuf at a fine and a broad radius",
         .measure = shape,
         .falloff = "linear",
         .unit = SampleUnit::pair,
         .presets = two_radii_presets},
    };
}

}  // namespace gloam::effect
