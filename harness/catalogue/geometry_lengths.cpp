// SPDX-License-Identifier: MIT
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/relatives_parts.hpp"
#include "reference/geometry/length.hpp"
#include "reference/geometry/radius_cap.hpp"

namespace gloam::catalogue {

using namespace check;

void append_geometry_lengths(Entries& entries) {
    const Values any =
        either(vector_of_length(3, log_uniform(1e-3, 10)), vector_of_length(3, log_uniform(1e-37, 1e38)))
            .and_value(glm::vec3(0))
            .and_special();
    entries.push_back(equation<float(glm::vec3)>(
        {.id = "LENGTH-vector",
         .function = "gloam_length",
         .file = "gloam/geometry/length.glsl",
         .title = "length of a vector of any size",
         .formula = "|v| = v . (v / |v|)",
         .source = "definition"},
        GLOAM_REFERENCE(gloam_length),
        {.domain = {any},
         .budget = {.ulp = 3},
         .promised = make_predicate<float(glm::vec3)>([](glm::dvec3 v) {
             return !(std::abs(v.x) + std::abs(v.y) + std::abs(v.z) > 1e38) && glm::length(v) >= 1e-30;
         })}));
    const Values radius = either(log_uniform(1, 4096), log_uniform(1e-37, 1e38)).and_special();
    entries.push_back(equation<glm::vec2(glm::vec2, float)>(
        {.id = "CS-G-cap",
         .function = "gloam_radius_cap",
         .file = "gloam/geometry/radius_cap.glsl",
         .title = "projected radius held below a cap",
         .formula = "r min(1, cap / max(r_x, r_y))",
         .source = "Gears of War 2 (Smedberg and Wright 2009)"},
        GLOAM_REFERENCE(gloam_radius_cap),
        {.domain = Domain{vector(2, radius), radius},
         .budget = {.ulp = 3.5},
         .codomain = {0, 3.5e38},
         .promised = make_predicate<glm::vec2(glm::vec2, float)>([](glm::dvec2 axes, double cap) {
             return moderate(1e-18, 1e18, axes, cap) && std::max(axes.x, axes.y) < 1e18;
         })}));
}

}  // namespace gloam::catalogue
