// SPDX-License-Identifier: MIT
#include "effect/internal/method_families.hpp"

namespace gloam::effect {
namespace {

using enum Measure;

// The study's values: 6 steps, a bias of 0.3 radians.
void adapt_hbao(Settings& s) {
    s.own.angle_bias = 0.3F;
    s.own.steps = 6;
}

// hbao at half the resolution: every other pixel in x and y has a result. A pixel reads 3 x 3 of them.
Preparation half_resolution(const Settings&, backend::Extent view) {
    const backend::Extent half{(view.width + 1) / 2, (view.height + 1) / 2};
    return {.image = half, .passes = {{"half_resolution", "half_resolution.comp", half}}, .spread = 3};
}

// Each pixel's occlusion along its first direction. Other pixels use it from up to two standard deviations
// away.
Preparation first_direction(const Settings& settings, backend::Extent view) {
    return {.image = view,
            .format = backend::vulkan::Format::r32f,
            .passes = {{"first_direction", "first_direction.comp", view}},
            .spread = 1,
            .reach = 2.0F * settings.own.epsilon};
}

std::vector<Preset> hbao_study_presets(const MethodInfo& method) {
    const auto with_samples = [](const char* origin) {
        return printed_by_study({{"samples", origin},
                                 {"samples_converged", origin},
                                 {"steps", "6 steps"},
                                 {"angle_bias", "bias, of the published shader"}});
    };
    return {
        {"study-hbao-performance", "the study's: 8 directions of 6 steps, its blur, no history",
         blurred(slices(method, 4, 6)), with_samples("8 x 6 samples")},
        {"study-hbao-quality", "the study's published shader: 8 directions of 6 steps, no blur, no history",
         studied(slices(method, 4, 6)), with_samples("of the published shader, not in print")}};
}

// Slices and steps to each side of XeGTAO's levels (Intel 2021), in single frames with a blur.
std::vector<Preset> gtao_presets(const MethodInfo& method) {
    const Printed levels{{"method", "GTAO"},
                         {"samples", "SliceCount times 2 StepsPerSlice"},
                         {"samples_converged", "SliceCount times 2 StepsPerSlice"},
                         {"steps", "StepsPerSlice"},
                         {"history", "none of its own"}};
    return {{"xegtao-low", "XeGTAO's 1 slice of 2 steps to each side, a blur, no history",
             blurred(slices(method, 1, 2)), levels},
            {"xegtao-medium", "its 2 slices of 2 steps", blurred(slices(method, 2, 2)), levels},
            {"xegtao-high", "its 3 slices of 3 steps", blurred(slices(method, 3, 3)), levels},
            {"xegtao-ultra", "its 9 slices of 3 steps", blurred(slices(method, 9, 3)), levels}};
}

}  // namespace

std::vector<MethodInfo> slice_methods() {
    return {
        {.name = "hbao",
         .description = "horizons above the image plane, all directions alike (after Bavoil and Sainz 2008): "
                        "steps dense nearby, what the bias takes off given back",
         .measure = uniform,
         .falloff = "quadratic",
         .own_settings = "GloamHbao",
         .members = {{"angle_bias"}, {"contrast", "intensity"}, {"steps"}},
         .unit = SampleUnit::slice,
         .adapt = adapt_hbao},
        {.name = "hbao_study",
         .family = "hbao",
         .description = "the same as the comparative study has it (Aalund and Baerentzen 2013)",
         .measure = uniform,
         .falloff = "quadratic",
         .own_settings = "GloamHbaoStudy",
         .members = {{"angle_bias"}, {"contrast", "intensity"}, {"steps"}},
         .unit = SampleUnit::slice,
         .adapt = adapt_hbao,
         .presets = hbao_study_presets},
        {.name = "gtao",
         .description = "horizon slices, cosine-weighted, divided by their weights (Jimenez et al. 2016)",
         .falloff = "linear",
         .own_settings = "GloamGtao",
         .members = {{"steps"}},
         .unit = SampleUnit::slice,
         .presets = gtao_presets},
        {.name = "sweep",
         .description =
             "horizon sweep: slices in which each direction counts with the falloff at its distance",
         .falloff = "linear",
         .own_settings = "GloamSweep",
         .members = {{"steps"},
                     {"feature_thickness"},
                     {.name = "falloff", .constant = "GLOAM_FALLOFF_LINEAR"}},
         .unit = SampleUnit::slice},
        {.name = "dual_resolution",
         .description = "hbao at half the resolution, in full where that disagrees (Bavoil and Sainz 2009)",
         .measure = uniform,
         .falloff = "quadratic",
         .own_settings = "GloamDualResolution",
         .members = {{"angle_bias"}, {"contrast", "intensity"}, {"steps"}, {"disagreement"}, {"layers"}},
         .unit = SampleUnit::slice,
         .adapt = adapt_hbao,
         .prepare = half_resolution},
        {.name = "separable",
         .description =
             "slices in two directions, the first one's carried along the second (Huang et al. 2011)",
         .falloff = "linear",
         .own_settings = "GloamSeparable",
         .members = {{"sigma", "epsilon"}},
         .unit = SampleUnit::cross,
         .adapt = [](Settings& s) { s.own.epsilon = 0.1F; },
         .prepare = first_direction},
        {.name = "bitmask",
         .description = "slices of 32 sectors between front and back (Therrien et al. 2023)",
         .falloff = "linear",
         .own_settings = "GloamBitmask",
         .members = {{"thickness"}, {"steps"}},
         .unit = SampleUnit::slice},
    };
}

}  // namespace gloam::effect
