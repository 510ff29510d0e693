// SPDX-License-Identifier: MIT
#include "catalogue/inputs.hpp"
#include "catalogue/temporal_parts.hpp"
#include "reference/temporal.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr double float_max = 0x1.fffffep127;

// Numbers of samples: integers, which are usual, and any others.
Values weights() {
    const Values whole =
        made_by<float>([](numeric::Random& random) { return static_cast<float>(random.below(1600)); });
    return either(whole, log_uniform(1e-6, 1e8)).and_near({16777216.0}).and_special();
}
Values occlusions() {
    return either(uniform(0, 1).and_near({0.0, 1.0}), log_uniform(1e-30, 2)).and_special();
}

void append_blend(Entries& entries) {
    using Signature = glm::vec2(float, float, float, float, float);
    const auto usual = [](double, double weight, double, double k, double weight_max) {
        return moderate(1e-30, 1e36, weight, k, weight_max);
    };
    entries.push_back(equation<Signature>(
        {.id = "TSSAO-5",
         .function = "gloam_blend",
         .file = "gloam/temporal/blend.glsl",
         .title = "blend of the history with new samples",
         .formula = "AO = AO' + (C - AO') k / (w' + k);  w = min(w' + k, w_max)",
         .source = "TSSAO (Mattausch et al.), eqs 4 and 5, arguments corrected"},
        &reference::gloam_blend,
        {.domain = Domain{occlusions(), weights(), occlusions(), weights(), weights()}.tied(4, 1).tied(2, 0),
         .budget = {.ulp = 0.5, .absolute = 1e-7},
         .codomain = {0, float_max},
         .promised = make_predicate<Signature>(usual)}));
    entries.push_back(equation<float(float, float, float)>(
        {.id = "TSSAO-5-weight",
         .function = "gloam_history_weight",
         .file = "gloam/temporal/blend.glsl",
         .title = "weight of a history value, if it can be one",
         .formula = "min(w', w_max) if 0 <= AO' <= 1, else 0",
         .source = "TSSAO (Mattausch et al.), edges of eq 5"},
        &reference::gloam_history_weight,
        {.domain = Domain{occlusions(), weights(), weights()}.tied(2, 1), .codomain = {0, float_max}}));
}

}  // namespace

void append_accumulation(Entries& entries) {
    const Values convergence = either(uniform(0, 1.1), log_uniform(1e-30, 1)).and_special();
    const Values threshold = uniform(0, 1).and_near({0.2, 0.3, 0.5}).and_special();
    append_blend(entries);
    entries.push_back(
        equation<float(float, float)>({.id = "TSSAO-6",
                                       .function = "gloam_convergence",
                                       .file = "gloam/temporal/convergence.glsl",
                                       .title = "how far a pixel has converged",
                                       .formula = "conv = w / w_max",
                                       .source = "TSSAO (Mattausch et al.), eq 6"},
                                      &reference::gloam_convergence,
                                      {.domain = Domain{weights(), weights().and_near({0x1p-126})}.tied(0, 1),
                                       .budget = {.ulp = 0.5},
                                       .codomain = {0, 1}}));
    entries.push_back(equation<bool(float, float)>({.id = "TSSAO-ROT",
                                                    .function = "gloam_rotation_enabled",
                                                    .file = "gloam/temporal/rotation_switch.glsl",
                                                    .title = "whether the kernel is rotated at random",
                                                    .formula = "conv < c_rot",
                                                    .source = "TSSAO (Mattausch et al.), random rotation"},
                                                   &reference::gloam_rotation_enabled,
                                                   {.domain = Domain{convergence, threshold}.tied(0, 1)}));
    entries.push_back(equation<int(float, float, int, int)>(
        {.id = "TSSAO-AS",
         .function = "gloam_sample_count",
         .file = "gloam/temporal/sample_budget.glsl",
         .title = "samples to take in this frame",
         .formula = "k = k_1 if conv < c_spatial, else k_2",
         .source = "TSSAO (Mattausch et al.), adaptive sampling"},
        &reference::gloam_sample_count,
        {.domain = Domain{convergence, threshold, integers(0, 64).and_near_integers({0, -2147483647L}),
                          integers(0, 64).and_near_integers({0, 2147483646L})}
                       .tied(0, 1)}));
}

}  // namespace gloam::catalogue
