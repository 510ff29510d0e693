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
Preparation half_resolution(const Settings&, gpu::Extent view) {
    const gpu::Extent half{(view.width + 1) / 2, (view.height + 1) / 2};
    return {.image = half, .passes = {{"half_resolution", "half_resolution.comp", half}}, .spread = 3};
}

// Each pixel's occlusion along its first direction. Other pixels use it from up to two standard deviations
// away.
Preparation first_direction(const Settings& settings, gpu::Extent view) {
    return {.image = view,
            .format = gpu::Format::r32f,
            .passes = {{"first_direction", "first_direction.comp", view}},
            .spread = 1,
            .reach = 2.0F * settings.own.epsilon};
}

std::vector<Preset> hbao_study_presets(const MethodInfo& method) {
    return {{"hbao-performance", "the study's: 8 directions of 6 steps, its blur, no history",
             blurred(slices(method, 4, 6))},
            {"hbao-quality", "the study's published shader: 8 directions of 6 steps, no blur, no history",
             studied(slices(method, 4, 6))}};
}

std::vector<Preset> slice_presets(const MethodInfo& method) {
    return {{method.name + "-performance", "1 slice of 2 steps to each side", slices(method, 1, 2)},
            {method.name + "-quality", "9 slices of 3 steps to each side", slices(method, 9, 3)}};
}

std::vector<Preset> gtao_presets(const MethodInfo& method) {
    std::vector<Preset> presets = slice_presets(method);
    presets.push_back({method.name + "-plain",
                       "9 slices of 3 steps to each side, no filter: what other presets are compared with",
                       studied(slices(method, 9, 3))});
    return presets;
}

// Settings with a history, like those of the general presets: a mean over 128 samples, kernels always
// rotated, a filter in the first frames. The samples of a slice share one direction, so the noise follows the
// number of slices: pixels with fewer than eight are filtered.
Settings swept(const MethodInfo& method, std::uint32_t count, std::uint32_t steps) {
    Settings settings = slices(method, count, steps);
    settings.weight_max = 128.0F;
    settings.c_rot = 2.0F;
    settings.rotation = Rotation::hilbert;
    settings.filter = Filter::convergence;
    settings.c_adaptive = 8.0F * static_cast<float>(2 * steps) / settings.weight_max;
    settings.filter_frames = 8.0F;
    settings.precision = HistoryPrecision::packed;
    return settings;
}

// A pixel with few samples is a blob of several pixels of the view, so pixels that come into view later are
// filtered as well.
Settings at_half_resolution(Settings settings) {
    settings.resolution = Resolution::half;
    settings.filter_frames = every_frame;
    return settings;
}

std::vector<Preset> sweep_presets(const MethodInfo& method) {
    return {
        {"sweep-half", "sweep-balanced at half the resolution, always filtered: for the least time",
         at_half_resolution(swept(method, 1, 6))},
        {"sweep-performance",
         "1 slice of 2 steps to each side, a frame; 128 samples in the mean, filtered in the first 8 frames",
         swept(method, 1, 2)},
        {"sweep-balanced",
         "1 slice of 6 steps to each side, a frame; 128 samples in the mean, filtered in the first 8 frames",
         swept(method, 1, 6)},
        {"sweep-quality",
         "4 slices of 6 steps to each side, a frame; 128 samples in the mean, filtered in the first 8 frames",
         swept(method, 4, 6)}};
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
         .points = "halton",
         .unit = SampleUnit::slice,
         .ends_marches = true,
         .adapt = adapt_hbao},
        {.name = "hbao_study",
         .family = "hbao",
         .description = "the same as the comparative study has it (Aalund and Baerentzen 2013)",
         .measure = uniform,
         .falloff = "quadratic",
         .own_settings = "GloamHbaoStudy",
         .members = {{"angle_bias"}, {"contrast", "intensity"}, {"steps"}},
         .points = "halton",
         .unit = SampleUnit::slice,
         .adapt = adapt_hbao,
         .presets = hbao_study_presets},
        {.name = "gtao",
         .description = "horizon slices, cosine-weighted, divided by their weights (Jimenez et al. 2016)",
         .measure = cosine,
         .falloff = "linear",
         .own_settings = "GloamGtao",
         .members = {{"steps"}},
         .points = "halton",
         .unit = SampleUnit::slice,
         .presets = gtao_presets},
        {.name = "sweep",
         .description =
             "horizon sweep: slices in which each direction counts with the falloff at its distance",
         .measure = cosine,
         .falloff = "linear",
         .own_settings = "GloamSweep",
         .members = {{"steps"},
                     {"feature_thickness"},
                     {.name = "falloff", .constant = "GLOAM_FALLOFF_LINEAR"}},
         .points = "halton",
         .unit = SampleUnit::slice,
         .presets = sweep_presets},
        {.name = "dual_resolution",
         .description = "hbao at half the resolution, in full where that disagrees (Bavoil and Sainz 2009)",
         .measure = uniform,
         .falloff = "quadratic",
         .own_settings = "GloamDualResolution",
         .members = {{"angle_bias"}, {"contrast", "intensity"}, {"steps"}, {"disagreement"}},
         .points = "halton",
         .unit = SampleUnit::slice,
         .ends_marches = true,
         .adapt = adapt_hbao,
         .prepare = half_resolution},
        {.name = "separable",
         .description =
             "slices in two directions, the first one's carried along the second (Huang et al. 2011)",
         .measure = cosine,
         .falloff = "linear",
         .own_settings = "GloamSeparable",
         .members = {{"sigma", "epsilon"}},
         .points = "halton",
         .unit = SampleUnit::cross,
         .adapt = [](Settings& s) { s.own.epsilon = 0.1F; },
         .prepare = first_direction},
        {.name = "bitmask",
         .description = "slices of 32 sectors between front and back (Therrien et al. 2023)",
         .measure = cosine,
         .falloff = "linear",
         .own_settings = "GloamBitmask",
         .members = {{"thickness"}, {"steps"}},
         .points = "halton",
         .unit = SampleUnit::slice,
         .ends_marches = true,
         .presets = slice_presets},
    };
}

}  // namespace gloam::effect
