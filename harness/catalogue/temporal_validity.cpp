// SPDX-License-Identifier: MIT
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/temporal_parts.hpp"
#include "numeric/constants.hpp"
#include "reference/temporal.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr double float_max = 0x1.fffffep127;

void append_disocclusion(Entries& entries) {
    constexpr const char* file = "gloam/temporal/disocclusion.glsl";
    const Values depth =
        either(uniform(1, 4), log_uniform(1e-3, 1e6)).and_near({0x1p-126, float_max}).and_special();
    const Domain depths{depth, depth};
    const Values epsilon = either(uniform(0.005, 0.05), log_uniform(1e-6, 2)).and_special();
    entries.push_back(equation<bool(float, float, float)>(
        {.id = "TSSAO-8",
         .function = "gloam_depth_consistent",
         .file = file,
         .title = "whether the history is of the same surface",
         .formula = "|d' - d~| < epsilon d', d~ the point's depth in the previous camera",
         .source = "TSSAO (Mattausch et al.), eq 8"},
        &reference::gloam_depth_consistent,
        {.domain = Domain{depth, depth, epsilon}
                       .tied(1, 0)
                       .tied(1, 0, 1.01)
                       .tied(1, 0, 0.99)
                       .tied(1, 0, 1.005)
                       .tied(1, 0, 1.02),
         .budget = {.backward_ulp = 2},
         .promised =
             make_predicate<bool(float, float, float)>([](double stored, double expected, double epsilon) {
                 return moderate(1e-30, 1e37, stored, expected) && moderate(1e-7, 1e37, epsilon);
             })}));
    entries.push_back(
        equation<bool(float, float)>({.id = "TSSAO-8-background",
                                      .function = "gloam_both_background",
                                      .file = file,
                                      .title = "whether there was nothing before and is nothing now",
                                      .formula = "both depths background",
                                      .source = "TSSAO (Mattausch et al.), edge of eq 8"},
                                     &reference::gloam_both_background, {.domain = depths}));
}

void append_neighborhood(Entries& entries) {
    constexpr const char* file = "gloam/temporal/neighborhood.glsl";
    constexpr const char* source = "TSSAO (Mattausch et al.), eq 9";
    const Values position = either(vector(3, uniform(-8, 8)), vector(3, uniform(-0.5, 0.5)))
                                .and_value(glm::vec3(0))
                                .and_special();
    const auto near = [](glm::dvec3 p) { return moderate(1e-30, 16, p); };
    entries.push_back(equation<float(glm::vec3, glm::vec3, glm::vec3, glm::vec3)>(
        {.id = "TSSAO-9",
         .function = "gloam_neighborhood_change",
         .file = file,
         .title = "change of the distance to a neighbouring point",
         .formula = "||s - p| - |s' - p'||",
         .source = source},
        &reference::gloam_neighborhood_change,
        {.domain = {position, position, position, position},
         .budget = {.ulp = 4, .absolute = 6e-6},
         .codomain = {0, float_max},
         .promised = make_predicate<float(glm::vec3, glm::vec3, glm::vec3, glm::vec3)>(
             [near](glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
                 return near(a) && near(b) && near(c) && near(d);
             })}));
    const Values change = either(log_uniform(1e-6, 1), uniform(0, 0.1)).and_special();
    entries.push_back(equation<bool(float, float)>({.id = "TSSAO-9-test",
                                                    .function = "gloam_neighborhood_unchanged",
                                                    .file = file,
                                                    .title = "whether a neighbourhood counts as unchanged",
                                                    .formula = "d < epsilon",
                                                    .source = source},
                                                   &reference::gloam_neighborhood_unchanged,
                                                   {.domain = Domain{change, change}.tied(0, 1)}));
    entries.push_back(equation<bool(glm::vec3, glm::vec3)>(
        {.id = "TSSAO-9-probe",
         .function = "gloam_probe_useful",
         .file = file,
         .title = "whether a surface point can block another at all",
         .formula = "(s - p) . n > 0",
         .source = source},
        &reference::gloam_probe_useful,
        {.domain = {position, unit_vector(3).and_special()},
         .budget = {.backward_ulp = 4},
         .promised = make_predicate<bool(glm::vec3, glm::vec3)>(
             [](glm::dvec3 offset, glm::dvec3 normal) { return moderate(1e-15, 1e15, offset, normal); })}));
}

void append_invalidation(Entries& entries) {
    constexpr const char* file = "gloam/temporal/smooth_invalidation.glsl";
    const Values weight = either(uniform(0, 1500), log_uniform(1e-30, 1e30)).and_special();
    entries.push_back(
        equation<float(float, float)>({.id = "TSSAO-SI-a",
                                       .function = "gloam_invalidate_clamp",
                                       .file = file,
                                       .title = "smooth invalidation by clamping the weight",
                                       .formula = "w := min(w, w_small)",
                                       .source = "TSSAO (Mattausch et al.), notes on smooth invalidation"},
                                      &reference::gloam_invalidate_clamp,
                                      {.domain = Domain{weight, uniform(32, 64).and_special()}.tied(0, 1),
                                       .codomain = {0, numeric::infinity}}));
    entries.push_back(equation<float(float, float)>(
        {.id = "TSSAO-SI-b",
         .function = "gloam_confidence",
         .file = file,
         .title = "confidence in the history after a change",
         .formula = "conf = 1 / (1 + S d)",
         .source = "TSSAO (Mattausch et al.), smooth invalidation factor"},
        &reference::gloam_confidence,
        {.domain = {either(uniform(0, 1), signed_log_uniform(1e-30, 1e30)).and_special(),
                    either(uniform(15, 30), log_uniform(1e-6, 1e6)).and_special()},
         .budget = {.ulp = 3},
         .codomain = {0, 1}}));
    entries.push_back(
        equation<float(float, float)>({.id = "TSSAO-SI-b-weight",
                                       .function = "gloam_invalidate_confidence",
                                       .file = file,
                                       .title = "smooth invalidation by a confidence",
                                       .formula = "w := conf w",
                                       .source = "TSSAO (Mattausch et al.), smooth invalidation factor"},
                                      &reference::gloam_invalidate_confidence,
                                      {.domain = {weight, uniform(0, 1).and_near({0.0, 1.0}).and_special()},
                                       .budget = {.ulp = 0.5},
                                       .codomain = {0, float_max}}));
}

}  // namespace

void append_validity(Entries& entries) {
    append_disocclusion(entries);
    append_neighborhood(entries);
    append_invalidation(entries);
}

}  // namespace gloam::catalogue
