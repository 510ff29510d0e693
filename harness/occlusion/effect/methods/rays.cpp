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

// Frames alone, as published, with the study's blur, because the sources name none.
Settings alone(const MethodInfo& method, std::uint32_t count, std::uint32_t steps) {
    return blurred(rays(method, count, steps));
}

std::vector<Preset> poisson_presets(const MethodInfo& method) {
    const Printed rays_printed{{"method", "rays of a lifted Poisson disc"},
                               {"samples", "rays times steps"},
                               {"samples_converged", "rays times steps"},
                               {"steps", "steps of a ray"},
                               {"history", "none in the source"}};
    return {{"sourimant-least", "Sourimant's least: 8 rays of 4 steps, no history; the blur is ours",
             alone(method, 8, 4), rays_printed},
            {"sourimant-most", "Sourimant's most: 24 rays of 8 steps, no history; the blur is ours",
             alone(method, 24, 8), rays_printed}};
}

std::vector<Preset> unreal_presets(const MethodInfo& method) {
    return {{"unreal-quality",
             "the engine's 6 mirrored directions of 3 steps, no history; the blur is ours",
             alone(method, 12, 3),
             {{"method", "the later shader"},
              {"samples", "6 mirrored offsets of 3 steps"},
              {"samples_converged", "6 mirrored offsets of 3 steps"},
              {"steps", "steps of a side"},
              {"epsilon", "0.8"},
              {"history", "none in the shader"}}}};
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
         .unit = SampleUnit::ray,
         .adapt = adapt_hsao},
        {.name = "poisson",
         .description = "rays of a lifted Poisson disc (Sourimant et al. 2011)",
         .falloff = "none up to the radius",
         .own_settings = "GloamPoisson",
         .members = {{"range"}, {"steps"}},
         .unit = SampleUnit::ray,
         .presets = poisson_presets},
        {.name = "ssdo",
         .description = "what of light from everywhere does not arrive (Ritschel, Grosch and Seidel 2009)",
         .falloff = "linear",
         .own_settings = "GloamSsdo",
         .members = {{"range"}, {"steps"}, {"layers"}},
         .unit = SampleUnit::ray,
         .adapt = [](Settings& s) { s.own.steps = 1; }},
        {.name = "unreal",
         .description = "nearest steps to both sides, the later shader of Unreal Engine 4",
         .measure = shape,
         .falloff = "1 / distance",
         .own_settings = "GloamUnreal",
         .members = {{"epsilon"}, {"intensity"}, {"steps"}},
         .unit = SampleUnit::ray,
         .adapt = adapt_unreal,
         .presets = unreal_presets},
    };
}

}  // namespace gloam::effect
