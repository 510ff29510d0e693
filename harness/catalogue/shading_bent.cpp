// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdint>
#include <utility>

#include "catalogue/inputs.hpp"
#include "catalogue/relatives_parts.hpp"
#include "numeric/constants.hpp"
#include "reference/shading.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr const char* klehm = "Klehm et al. 2011";
constexpr const char* normal_file = "gloam/shading/bent_normal.glsl";
constexpr const char* cone_file = "gloam/shading/bent_cone.glsl";

// The sums over a few directions.
Values sums() {
    return made_by<glm::vec4>([](numeric::Random& random) {
        glm::dvec4 bent(0);
        const std::uint64_t directions = random.below(12);
        for (std::uint64_t i = 0; i < directions; ++i) {
            const glm::dvec3 v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 1));
            bent += random.unit() * glm::dvec4(glm::normalize(v), 1.0);
        }
        return bent;
    });
}

void append_sums(Entries& entries) {
    entries.push_back(equation<glm::vec4(glm::vec4, glm::vec3, float)>(
        {.id = "CS-L-add",
         .function = "gloam_bent_add",
         .file = normal_file,
         .title = "one more direction in a bent normal",
         .formula = "(sum of V w + V w, sum of V + V)",
         .source = klehm},
        &reference::gloam_bent_add,
        {.domain = {sums(), unit_vector(3).and_special(), uniform(0, 1).and_special()},
         .budget = {.absolute = 1e-6},
         .codomain = {-numeric::largest_float, numeric::largest_float},
         .promised = make_predicate<glm::vec4(glm::vec4, glm::vec3, float)>(
             [](glm::dvec4 bent, glm::dvec3 w, double) { return moderate(0.0, 16, bent, w); })}));
    entries.push_back(
        equation<glm::vec3(glm::vec4, glm::vec3)>({.id = "CS-L",
                                                   .function = "gloam_bent_normal",
                                                   .file = normal_file,
                                                   .title = "bent normal",
                                                   .formula = "b = sum of V w / |sum of V w|",
                                                   .source = klehm},
                                                  &reference::gloam_bent_normal,
                                                  {.domain = {sums().and_special(), unit_vector(3)},
                                                   .budget = {.ulp = 3},
                                                   .codomain = {-1.000001, 1.000001}}));
    entries.push_back(
        equation<float(glm::vec4)>({.id = "CS-L-length",
                                    .function = "gloam_bent_length",
                                    .file = normal_file,
                                    .title = "how much the open directions agree",
                                    .formula = "L = |sum of V w| / sum of V",
                                    .source = klehm},
                                   &reference::gloam_bent_length,
                                   {.domain = {sums().and_value(glm::vec4(0)).and_special()},
                                    .budget = {.absolute = 4e-7},
                                    .codomain = {0, 1},
                                    .promised = make_predicate<float(glm::vec4)>([](glm::dvec4 bent) {
                                        return moderate(1e-18, 1e18, bent) && std::abs(bent.w) < 1e18 &&
                                               glm::length(glm::dvec3(bent)) < 1e18;
                                    })}));
}

template <class Reference>
void append_cone(Entries& entries, Description description, double absolute, Reference reference) {
    description.file = cone_file;
    const Values value = either(uniform(0, 1), either(log_uniform(1e-12, 1), uniform(0.999, 1.001)))
                             .and_near({0.5, 1.0})
                             .and_special();
    entries.push_back(equation<float(float)>(
        std::move(description), reference,
        {.domain = {value}, .budget = {.absolute = absolute}, .codomain = {0, 1.5707965}}));
}

}  // namespace

void append_shading_bent(Entries& entries) {
    append_sums(entries);
    append_cone(entries,
                {.id = "CS-L-cone-linear",
                 .function = "gloam_cone_angle_linear",
                 .title = "half angle of the open cone, as published",
                 .formula = "(1 - max(0, 2 L - 1)) pi / 2",
                 .source = klehm},
                2e-7, &reference::gloam_cone_angle_linear);
    append_cone(entries,
                {.id = "CS-L-cone",
                 .function = "gloam_cone_angle",
                 .title = "half angle of the open cone, exact for a cap",
                 .formula = "arccos(max(0, 2 L - 1))",
                 .source = "derived: L = (1 + cos a) / 2"},
                4e-7, &reference::gloam_cone_angle);
    append_cone(entries,
                {.id = "CS-L-cone-uniform",
                 .function = "gloam_cone_angle_uniform",
                 .title = "half angle from visibility, uniform measure",
                 .formula = "arccos(1 - v)",
                 .source = "derived: v = 1 - cos a"},
                6e-7, &reference::gloam_cone_angle_uniform);
    append_cone(entries,
                {.id = "CS-L-cone-cosine",
                 .function = "gloam_cone_angle_cosine",
                 .title = "half angle from visibility, cosine measure",
                 .formula = "arcsin(sqrt(v))",
                 .source = "derived: v = sin^2 a"},
                4e-7, &reference::gloam_cone_angle_cosine);
}

}  // namespace gloam::catalogue
