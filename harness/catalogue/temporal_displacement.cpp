// SPDX-License-Identifier: MIT
#include "catalogue/inputs.hpp"
#include "catalogue/temporal_parts.hpp"
#include "reference/temporal.hpp"

namespace gloam::catalogue {

using namespace check;

void append_displacement(Entries& entries) {
    constexpr Origin origin{"gloam/temporal/displacement.glsl",
                            "gloam: the motion that TSSAO's equation 9 reads, in 32 bits"};
    const Values component = either(uniform(-8, 8), log_uniform(1e-30, 1e30)).and_special();
    const Values unit = either(uniform(1e-4, 1e-3), log_uniform(1e-6, 1));
    entries.push_back(equation<unsigned(glm::vec3, float)>(
        {.id = "DISPLACED-code",
         .function = "gloam_displacement_to_code",
         .file = origin.file,
         .title = "displacement in 32 bits",
         .formula = "27 bits of components, 5 of their exponent",
         .source = origin.source},
        &reference::gloam_displacement_to_code,
        {.domain = {either(vector(3, component), vector(3, uniform(-0.05, 0.05))), unit},
         .budget = {.backward_ulp = 4},
         .codomain = {0, 4294967295.0},
         .promised = make_predicate<unsigned(glm::vec3, float)>(
             [](glm::dvec3 displacement, double) { return moderate(1e-30, 1e30, displacement); })}));
    entries.push_back(equation<glm::vec3(unsigned, float)>(
        {.id = "DISPLACED-of",
         .function = "gloam_displacement_from_code",
         .file = origin.file,
         .title = "displacement from 32 bits",
         .formula = "the inverse of DISPLACED-code",
         .source = origin.source},
        &reference::gloam_displacement_from_code,
        {.domain = {log_integers(4294967295).and_near_integers({134217727, 4227727103}), unit},
         .budget = {.ulp = 1},
         .codomain = {-0x1p40, 0x1p40}}));
}

}  // namespace gloam::catalogue
