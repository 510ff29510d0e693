// SPDX-License-Identifier: MIT
#include "effect/internal/method_families.hpp"

namespace gloam::effect {
namespace {

using enum Measure;

std::vector<Preset> crytek_presets(const MethodInfo& method) {
    return {{"crytek-performance", "the comparative study's: 24 samples, its blur, no history",
             blurred(configuration(method, 24))},
            {"crytek-quality", "the study's: 200 samples, no blur, no history",
             studied(configuration(method, 200))}};
}

std::vector<Preset> filion_presets(const MethodInfo& method) {
    return {{"filion-performance", "the study's: 15 samples, its blur, no history",
             blurred(configuration(method, 15))},
            {"filion-quality", "the study's: 80 samples, no blur, no history",
             studied(configuration(method, 80))}};
}

}  // namespace

std::vector<MethodInfo> point_methods() {
    return {
        {.name = "hemisphere",
         .description = "occlusion by points in the half ball (TSSAO-3, TSSAO-14)",
         .measure = cosine,
         .falloff = "linear",
         .own_settings = "GloamHemisphere",
         .members = {{"range"}},
         .points = "hemisphere_cosine",
         .open_proof = OpenProof::points},
        {.name = "crytek",
         .family = "hemisphere",
         .description = "points of a whole ball (Mittring 2007)",
         .measure = volume,
         .falloff = "none",
         .points = "hemisphere_uniform",
         .on_a_plane = 0.5,
         .adapt = [](Settings& s) { s.remap_a = 0.5F, s.bias = 0.0F; },
         .presets = crytek_presets},
        {.name = "filion",
         .family = "hemisphere",
         .description = "points of the half ball, uniform (Filion and McNaughton 2008)",
         .measure = uniform,
         .falloff = "linear",
         .points = "hemisphere_uniform",
         .open_proof = OpenProof::points,
         .presets = filion_presets},
    };
}

}  // namespace gloam::effect
