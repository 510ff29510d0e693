// SPDX-License-Identifier: MIT
#include "effect/internal/method_families.hpp"

namespace gloam::effect {
namespace {

using enum Measure;

// The values of hbao.
void adapt_hsao(Settings& s) {
    s.own.angle_bias = 0.3F;
    s.own.steps = 6;
}

// The engine's values: 0.8 of its unit, up to 3 steps on each side.
void adapt_unreal(Settings& s) {
    s.own.epsilon = 0.8F;
    s.own.steps = 3;
}

// Rays and steps of a frame. The history weighs by rays: as default settings keep 500 samples of 32 a frame,
// it keeps those of 16 frames. What objects covered before is visible for as long.
Settings remembered_rays(const MethodInfo& method, std::uint32_t count, std::uint32_t steps) {
    constexpr std::uint32_t frames = 16;
    Settings settings = rays(method, count, steps);
    settings.weight_max = static_cast<float>(frames * count);
    return settings;
}

std::vector<Preset> poisson_presets(const MethodInfo& method) {
    return {{"sourimant-least", "Sourimant's least: 8 rays of 4 steps", remembered_rays(method, 8, 4)},
            {"sourimant-most", "Sourimant's most: 24 rays of 8 steps", remembered_rays(method, 24, 8)}};
}

std::vector<Preset> unreal_presets(const MethodInfo& method) {
    return {
        {"unreal-quality", "the engine's 6 mirrored directions of 3 steps", remembered_rays(method, 12, 3)}};
}

}  // namespace

std::vector<MethodInfo> ray_methods() {
    return {
        {.name = "hsao",
         .family = "hbao",
         .description = "the same horizons, marched in eye space (Dimitrov, Bavoil and Sainz 2008)",
         .measure = uniform,
         .falloff = "quadratic",
         .own_settings = "GloamHsao",
         .members = {{"angle_bias"}, {"contrast", "intensity"}, {"steps"}},
         .points = "halton",
         .unit = SampleUnit::ray,
         .adapt = adapt_hsao},
        {.name = "poisson",
         .description = "rays of a lifted Poisson disc (Sourimant et al. 2011)",
         .measure = cosine,
         .falloff = "none up to the radius",
         .own_settings = "GloamPoisson",
         .members = {{"range"}, {"steps"}},
         .points = "halton",
         .unit = SampleUnit::ray,
         .presets = poisson_presets},
        {.name = "ssdo",
         .description = "what of light from everywhere does not arrive (Ritschel, Grosch and Seidel 2009)",
         .measure = cosine,
         .falloff = "linear",
         .own_settings = "GloamSsdo",
         .members = {{"range"}, {"steps"}, {"layers"}},
         .points = "halton",
         .unit = SampleUnit::ray,
         .adapt = [](Settings& s) { s.own.steps = 1; }},
        {.name = "unreal",
         .description = "nearest steps to both sides, the later shader of Unreal Engine 4",
         .measure = shape,
         .falloff = "1 / distance",
         .own_settings = "GloamUnreal",
         .members = {{"epsilon"}, {"intensity"}, {"steps"}},
         .points = "halton",
         .unit = SampleUnit::ray,
         .adapt = adapt_unreal,
         .presets = unreal_presets},
    };
}

}  // namespace gloam::effect
