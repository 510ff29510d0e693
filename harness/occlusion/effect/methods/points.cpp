// SPDX-License-Identifier: MIT
#include "effect/internal/method_families.hpp"

namespace gloam::effect {
namespace {

using enum Measure;

// Table 1 of the paper, with lengths for a radius of 1: the defaults of Settings.
std::vector<Preset> tssao_presets(const MethodInfo&) {
    return {{"tssao-paper",
             "the TSSAO paper's table 1: 32 samples a frame, 500 in the mean",
             {},
             {{"method", "eqs 3 and 14"},
              {"samples", "k_1"},
              {"samples_converged", "k_2, 8 to 16"},
              {"c_spatial", "c_spatial"},
              {"weight_max", "w_max, 500 to 1500"},
              {"c_rot", "c_rot"},
              {"c_adaptive", "c_adaptive"},
              {"depth_tolerance", "epsilon of eq 8, whose value is ours"},
              {"history", "eq 5"},
              {"invalidation", "smooth invalidation"},
              {"change_tolerance", "epsilon of eq 9, whose value is ours"},
              {"confidence_factor", "S, 15 to 30, in a formula that is reconstructed"},
              {"filter", "eq 10"},
              {"filter_half_width", "F, 5 x 5"}}}};
}

// Values of the study for points of a ball.
Printed points_printed() {
    return printed_by_study({{"samples", "N"}, {"samples_converged", "N"}, {"remap_a", "a"}});
}

std::vector<Preset> crytek_presets(const MethodInfo& method) {
    return {{"study-crytek-performance", "the comparative study's: 24 samples, its blur, no history",
             blurred(configuration(method, 24)), points_printed()},
            {"study-crytek-quality", "the study's: 200 samples, no blur, no history",
             studied(configuration(method, 200)), points_printed()}};
}

std::vector<Preset> filion_presets(const MethodInfo& method) {
    return {{"study-filion-performance", "the study's: 15 samples, its blur, no history",
             blurred(configuration(method, 15)), points_printed()},
            {"study-filion-quality", "the study's: 80 samples, no blur, no history",
             studied(configuration(method, 80)), points_printed()}};
}

// The number of samples of the study's published shaders, which its text does not print.
Printed shader_printed(Printed more = {}) {
    more.insert(more.end(), {{"samples", "of the published shader, not in print"},
                             {"samples_converged", "of the published shader, not in print"}});
    return printed_by_study(more);
}

std::vector<Preset> volumetric_presets(const MethodInfo& method) {
    return {
        {"study-volumetric-performance",
         "the study's: pairs of lines, a blur of one pixel, no history; the 6 pairs are ours",
         blurred(configuration(method, 12), 1),
         printed_by_study({{"remap_a", "a"}, {"filter_half_width", "1 pixel"}})},
        {"study-volumetric-quality", "the study's: 32 pairs of lines as in its shader, no blur, no history",
         studied(configuration(method, 64)), shader_printed({{"remap_a", "a"}})}};
}

// The game's other settings are not published. The number of pairs, 6, is that of
// study-volumetric-performance.
std::vector<Preset> spiral_presets(const MethodInfo& method) {
    return {{"toy-story-3",
             "the game's: pairs on a turned spiral, 6 here; a blur of one pixel",
             blurred(configuration(method, 12), 1),
             {{"method", "pairs of lines on a turned spiral"}}}};
}

std::vector<Preset> angle_presets(const MethodInfo& method) {
    const Printed lengths{{"range", "T, of the published shader"},
                          {"angle_bias", "bias, of the published shader"}};
    return {{"study-angle-performance",
             "the study's blur, no history; the 6 pairs are ours: print has a 6, of pairs or of samples",
             blurred(configuration(method, 12)), printed_by_study(lengths)},
            {"study-angle-quality", "the study's: 32 pairs as in its shader, no blur, no history",
             studied(configuration(method, 64)), shader_printed(lengths)}};
}

}  // namespace

std::vector<MethodInfo> point_methods() {
    return {
        {.name = "hemisphere",
         .description = "occlusion by points in the half ball (TSSAO-3, TSSAO-14)",
         .falloff = "linear",
         .own_settings = "GloamHemisphere",
         .members = {{"range"}, {"layers"}},
         .presets = tssao_presets},
        {.name = "crytek",
         .family = "hemisphere",
         .description = "points of a whole ball (Mittring 2007)",
         .measure = volume,
         .falloff = "none",
         .on_a_plane = 0.5,
         .adapt = [](Settings& s) { s.remap_a = 0.5F, s.bias = 0.0F; },
         .presets = crytek_presets},
        {.name = "filion",
         .family = "hemisphere",
         .description = "points of the half ball, uniform (Filion and McNaughton 2008)",
         .measure = uniform,
         .falloff = "linear",
         .presets = filion_presets},
    };
}

std::vector<MethodInfo> volumetric_methods() {
    return {
        {.name = "volumetric",
         .description = "solid share of a ball, by paired lines (Loos and Sloan 2010)",
         .measure = volume,
         .falloff = "none",
         .unit = SampleUnit::pair,
         .on_a_plane = 0.5,
         .adapt = [](Settings& s) { s.remap_a = 0.5F; },
         .presets = volumetric_presets},
        {.name = "volumetric_two",
         .family = "volumetric",
         .description = "volumetric in a ball of a quarter of the radius and in the whole one",
         .measure = volume,
         .falloff = "none",
         .unit = SampleUnit::cross,
         .on_a_plane = 0.5,
         .adapt = [](Settings& s) { s.remap_a = 0.5F; }},
        {.name = "volumetric_spiral",
         .family = "volumetric",
         .description = "the same ball, pairs of lines on a turned spiral (Toy Story 3; Ownby et al. 2010)",
         .measure = volume,
         .falloff = "none",
         .unit = SampleUnit::pair,
         .on_a_plane = 0.5,
         .adapt = [](Settings& s) { s.remap_a = 0.5F; },
         .presets = spiral_presets},
        {.name = "tangent_sphere",
         .family = "volumetric",
         .description = "solid share of the ball on the surface, by lines (Szirmay-Kalos et al. 2009)",
         .measure = volume,
         .falloff = "none",
         .unit = SampleUnit::pair},
        {.name = "angle",
         .description = "angles between opposite samples, as in Unreal Engine 4 (Mittring 2012)",
         .measure = shape,
         .falloff = "none",
         .own_settings = "GloamAngle",
         .members = {{"range"}, {"angle_bias"}},
         .unit = SampleUnit::pair,
         .adapt = [](Settings& s) { s.own.angle_bias = 0.08F; },
         .presets = angle_presets},
        {.name = "depth_darkening",
         .description = "unsharp mask of the depth (Luft, Colditz and Deussen 2006)",
         .measure = shape,
         .falloff = "none",
         .own_settings = "GloamDepthDarkening",
         .members = {{"range"}, {"intensity"}},
         .unit = SampleUnit::pair},
    };
}

}  // namespace gloam::effect
