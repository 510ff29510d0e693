// SPDX-License-Identifier: MIT
#include "catalogue/inputs.hpp"
#include "catalogue/relatives_parts.hpp"
#include "reference/temporal.hpp"

namespace gloam::catalogue {

using namespace check;

void append_temporal_smoothing(Entries& entries) {
    const Values occlusion = uniform(0, 1).and_near({0.0, 1.0}).and_special();
    entries.push_back(equation<float(float, bool, float, float)>(
        {.id = "CS-G",
         .function = "gloam_temporal_smooth",
         .file = "gloam/temporal/smoothing.glsl",
         .title = "exponential mean over frames",
         .formula = "AO_n = AO_(n-1) + rate (AO - AO_(n-1)), AO where the history is not valid",
         .source = "Gears of War 2 (Smedberg and Wright 2009)"},
        &reference::gloam_temporal_smooth,
        {.domain = {occlusion, booleans(), occlusion, uniform(0, 1).and_near({0.0, 1.0}).and_special()},
         .budget = {.absolute = 2e-7},
         .codomain = {0, 1}}));
}

}  // namespace gloam::catalogue
