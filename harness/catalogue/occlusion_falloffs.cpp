// SPDX-License-Identifier: MIT
#include "catalogue/inputs.hpp"
#include "catalogue/occlusion_parts.hpp"
#include "reference/occlusion.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

using Falloff = float(float, float);

constexpr const char* file = "gloam/occlusion/falloff.glsl";
constexpr double subnormal_end = 0x1p-126;
constexpr double float_max = 0x1.fffffep127;

// Distances and radii of any size. Half of them are within a factor of two of each other, where a falloff
// changes most.
Domain distances() {
    const Values length = either(log_uniform(0.5, 2), signed_log_uniform(1e-37, 1e38))
                              .and_near({subnormal_end, float_max, 0x1p-64, 0x1p64})
                              .and_special();
    return Domain{length, length}.tied(0, 1).tied(0, 1, -1.0).tied(0, 1, 0.5).tied(0, 1, 5.541263545);
}

template <class Reference>
void append_falloff(Entries& entries, Description description, Reference reference, Budget budget) {
    description.file = file;
    entries.push_back(equation<Falloff>(std::move(description), std::move(reference),
                                        {.domain = distances(), .budget = budget, .codomain = {0, 1}}));
}

void append_polynomials(Entries& entries) {
    append_falloff(entries,
                   {.id = "FALLOFF-step",
                    .function = "gloam_falloff_step",
                    .title = "step falloff",
                    .formula = "D = 1 if d <= R, else 0",
                    .source = "TSSAO (Mattausch et al.), the simplest D of eq 1"},
                   &reference::gloam_falloff_step, {});
    append_falloff(entries,
                   {.id = "FALLOFF-linear",
                    .function = "gloam_falloff_linear",
                    .title = "linear falloff",
                    .formula = "D = max(1 - d / R, 0)",
                    .source = "Aalund and Baerentzen 2013, reference images"},
                   &reference::gloam_falloff_linear, {.ulp = 1.5});
    append_falloff(entries,
                   {.id = "FALLOFF-quadratic",
                    .function = "gloam_falloff_quadratic",
                    .title = "quadratic falloff",
                    .formula = "D = max(1 - d^2 / R^2, 0)",
                    .source = "horizon-based AO, Bavoil and Sainz 2008"},
                   &reference::gloam_falloff_quadratic, {.ulp = 3});
    append_falloff(entries,
                   {.id = "FALLOFF-cubic",
                    .function = "gloam_falloff_cubic",
                    .title = "cubic falloff",
                    .formula = "D = max(1 - d^3 / R^3, 0)",
                    .source = "derived: kernel uniform in the volume of a ball"},
                   &reference::gloam_falloff_cubic, {.ulp = 5});
    append_falloff(entries,
                   {.id = "FALLOFF-sao",
                    .function = "gloam_falloff_sao",
                    .title = "falloff of Scalable Ambient Obscurance",
                    .formula = "D = (1 - d^2 / R^2)^3 for d < R, else 0",
                    .source = "McGuire et al. 2012"},
                   &reference::gloam_falloff_sao, {.ulp = 10});
}

}  // namespace

void append_falloffs(Entries& entries) {
    append_polynomials(entries);
    append_falloff(entries,
                   {.id = "FALLOFF-exponential",
                    .function = "gloam_falloff_exponential",
                    .title = "exponential falloff, cut below 1/255",
                    .formula = "D = exp(-d / R), 0 where below 1/255",
                    .source = "TSSAO (Mattausch et al.), notes on eq 1"},
                   &reference::gloam_falloff_exponential, {.ulp = 10, .backward_ulp = 4});
    append_falloff(entries,
                   {.id = "FALLOFF-alchemy",
                    .function = "gloam_falloff_alchemy",
                    .title = "falloff of Alchemy",
                    .formula = "D = u d / max(u, d)^2",
                    .source = "McGuire et al. 2011"},
                   &reference::gloam_falloff_alchemy, {.ulp = 1});
    append_falloff(entries,
                   {.id = "FALLOFF-filion",
                    .function = "gloam_visibility_filion",
                    .title = "visibility of Filion and McNaughton",
                    .formula = "clamp((D - R) / D, 0, 1), 1 for D <= 0",
                    .source = "Filion and McNaughton 2008"},
                   &reference::gloam_visibility_filion, {.ulp = 2});
    entries.push_back(equation<float(float)>({.id = "FALLOFF-one",
                                              .function = "gloam_falloff_one",
                                              .file = file,
                                              .title = "no falloff",
                                              .formula = "D = 1",
                                              .source = "TSSAO (Mattausch et al.), Ritschel's kernel"},
                                             &reference::gloam_falloff_one,
                                             {.domain = {any_float().and_special()}, .codomain = {0, 1}}));
}

}  // namespace gloam::catalogue
