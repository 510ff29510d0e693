// SPDX-License-Identifier: MIT
// Horizon-based ambient occlusion.
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/occlusion_parts.hpp"
#include "reference/occlusion_slices.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr const char* hbao_file = "gloam/occlusion/hbao.glsl";
constexpr const char* hbao_source = "Bavoil and Sainz 2008; Aalund and Baerentzen 2013, eqs 3.2 to 3.4";
constexpr double half_pi = 1.5707964;

Values offsets() {
    return either(vector_of_length(3, uniform(0.05, 1.5)), vector_of_length(3, log_uniform(1e-30, 1e30)))
        .and_value(glm::vec3(0))
        .and_special();
}
Values radii() {
    return either(uniform(0.5, 2), log_uniform(1e-37, 1e38)).and_special();
}

void append_tangents(Entries& entries) {
    using Slope = float(glm::vec2, glm::vec3, glm::vec3);
    const Values small = uniform(-0.2, 0.2);
    entries.push_back(equation<Slope>(
        {.id = "CS-C-slope",
         .function = "gloam_tangent_slope",
         .file = hbao_file,
         .title = "slope of the tangent plane from derivatives of the position",
         .formula = "T.z / |T.xy|, T = x dP/du + y dP/dv",
         .source = hbao_source},
        &reference::gloam_tangent_slope,
        {.domain = {unit_vector(2),
                    vector({uniform(0.5, 1), small, signed_log_uniform(0.01, 100)}).and_special(),
                    vector({small, uniform(-1, -0.5), signed_log_uniform(0.01, 100)}).and_special()},
         .budget = {.ulp = 6, .absolute = 8e-6},
         .codomain = {-1e6, 1e6},
         .promised = make_predicate<Slope>([](glm::dvec2, glm::dvec3 u, glm::dvec3 v) {
             return moderate(1e-9, 1e9, u, v) && std::abs(u.x) >= 0.4 && std::abs(v.y) >= 0.4 &&
                    std::abs(u.y) <= 0.3 && std::abs(v.x) <= 0.3;
         })}));
    entries.push_back(equation<float(float)>(
        {.id = "CS-C-sine",
         .function = "gloam_sine_of_tangent",
         .file = hbao_file,
         .title = "sine of the angle with a tangent",
         .formula = "t / (1 + t^2)^(1/2), 1 from 1e6 on",
         .source = hbao_source},
        &reference::gloam_sine_of_tangent,
        {.domain =
             {either(uniform(-4, 4), signed_log_uniform(1e-30, 1e30)).and_near({1e6, -1e6}).and_special()},
         .budget = {.absolute = 2e-7},
         .codomain = {-1, 1}}));
}

void append_tangent_elevation(Entries& entries) {
    using Elevation = float(glm::vec3, glm::vec2);
    entries.push_back(
        equation<Elevation>({.id = "CS-C-tangent",
                             .function = "gloam_tangent_elevation",
                             .file = hbao_file,
                             .title = "elevation of the tangent plane above the image plane",
                             .formula = "atan(-(n.xy . direction) / n.z)",
                             .source = hbao_source},
                            &reference::gloam_tangent_elevation,
                            {.domain = {unit_vector(3).and_special(), unit_vector(2)},
                             .budget = {.absolute = 4e-7},
                             .codomain = {-half_pi, half_pi},
                             .promised = make_predicate<Elevation>([](glm::dvec3 n, glm::dvec2 direction) {
                                 const double across = n.x * direction.x + n.y * direction.y;
                                 return !(n.z * n.z + across * across < 0.05) && moderate(1e-30, 2, n);
                             })}));
}

void append_hbao_horizon(Entries& entries) {
    using Horizon = glm::vec2(glm::vec3, glm::vec2, glm::vec2);
    const Values bias = made_by<glm::vec2>([](numeric::Random& random) {
                            const double angle = random.uniform(0.0, 1.5707963);
                            return glm::vec2(std::cos(angle), std::sin(angle));
                        })
                            .and_value(glm::vec2(1, 0))
                            .only_as_drawn();
    entries.push_back(equation<Horizon>(
        {.id = "CS-C-horizon",
         .function = "gloam_hbao_horizon",
         .file = hbao_file,
         .title = "direction from which on something blocks",
         .formula = "(cos, sin) of min(t + bias, pi / 2), tan t = -(n.xy . direction) / n.z",
         .source = hbao_source},
        &reference::gloam_hbao_horizon,
        {.domain = {unit_vector(3).and_value(glm::vec3(0, 0, 1)).only_as_drawn(), unit_vector(2), bias},
         .budget = {.absolute = 4e-7},
         .codomain = {-1.000001, 1.000001},
         .promised = make_predicate<Horizon>([](glm::dvec3 n, glm::dvec2 direction, const glm::vec2&) {
             const double across = n.x * direction.x + n.y * direction.y;
             return !(n.z * n.z + across * across < 0.05) && (n.z > 0.0 || std::abs(across) > 1e-5);
         })}));
}

void append_hbao_march(Entries& entries) {
    entries.push_back(
        equation<glm::vec2(float, float)>({.id = "CS-C-start",
                                           .function = "gloam_hbao_start",
                                           .file = hbao_file,
                                           .title = "where the march along a direction starts",
                                           .formula = "(sin(min(t + bias, pi / 2)), 0)",
                                           .source = hbao_source},
                                          &reference::gloam_hbao_start,
                                          {.domain = {uniform(-1.5707963, 1.5707963).and_special(),
                                                      uniform(0, 0.6).and_near({0.0}).and_special()},
                                           .budget = {.absolute = 3e-7},
                                           .codomain = {-1.000001, 1.000001}}));
    entries.push_back(equation<glm::vec2(float, float)>(
        {.id = "CS-C-start-slope",
         .function = "gloam_hbao_start_slope",
         .file = hbao_file,
         .title = "where the study's march along a direction starts",
         .formula = "(sin(atan(tan t + tan bias)), 0)",
         .source = "Aalund and Baerentzen 2013, CS-C"},
        &reference::gloam_hbao_start_slope,
        {.domain = {either(uniform(-4, 4), signed_log_uniform(1e-3, 1e6)).and_special(),
                    uniform(0, 0.6).and_near({0.0, 1.5707963}).and_special()},
         .budget = {.absolute = 5e-7},
         .codomain = {-1, 1}}));
    using Step = glm::vec2(glm::vec2, glm::vec3, float);
    entries.push_back(
        equation<Step>({.id = "CS-C",
                        .function = "gloam_hbao_step",
                        .file = hbao_file,
                        .title = "one step of HBAO's march",
                        .formula = "occ + (sin S - sin H) (1 - |v|^2 / R^2), then H = S, where S > H",
                        .source = hbao_source},
                       &reference::gloam_hbao_step,
                       {.domain = {vector({uniform(-1, 1), uniform(0, 1)}), offsets(), radii()},
                        .budget = {.absolute = 1e-6, .backward_ulp = 4},
                        .codomain = {-1.000001, 3.000001},
                        .promised = make_predicate<Step>([](glm::dvec2, glm::dvec3 v, double radius) {
                            return moderate(1e-9, 1e9, v) && moderate(1e-9, 1e9, radius);
                        })}));
}

void append_hbao_step_size(Entries& entries) {
    using Size = glm::vec2(float, float, float, float);
    entries.push_back(equation<Size>(
        {.id = "CS-C-steps",
         .function = "gloam_hbao_step_size",
         .file = hbao_file,
         .title = "how far apart the steps are, and how many",
         .formula = "(R / (N + extra), N), N = floor(min(N_s, R))",
         .source = "Bavoil and Sainz 2008; NVIDIA's sample"},
        &reference::gloam_hbao_step_size,
        {.domain = Domain{either(uniform(0, 64), log_uniform(1e-37, 1e38)).and_near({1.0}).and_special(),
                          either(uniform(16, 128), log_uniform(1e-37, 1e38)).and_special(),
                          either(uniform(1, 32), log_uniform(1e-37, 1e38)).and_special(),
                          either(constant(0.0F), constant(1.0F)).and_special()}
                       .tied(0, 1)
                       .tied(2, 0),
         .budget = {.ulp = 2, .backward_ulp = 1},
         .codomain = {0, 8.6e37},
         .promised = make_predicate<Size>([](double radius, double largest, double steps, double extra) {
             return moderate(1e-9, 1e9, radius, largest, steps, extra);
         })}));
}

void append_hbao_results(Entries& entries) {
    entries.push_back(equation<float(float, float, float)>(
        {.id = "CS-C-visibility",
         .function = "gloam_hbao_visibility",
         .file = hbao_file,
         .title = "visibility from HBAO's mean over directions",
         .formula = "1 - contrast occ / (1 - sin bias)",
         .source = "NVIDIA's sample of Bavoil and Sainz 2008"},
        &reference::gloam_hbao_visibility,
        {.domain = {uniform(0, 1).and_special(), uniform(0, 0.8).and_near({0.0}).and_special(),
                    uniform(0.5, 2).and_special()},
         .budget = {.absolute = 5e-7},
         .codomain = {0, 1},
         .promised = make_predicate<float(float, float, float)>([](double occlusion, double bias,
                                                                   double contrast) {
             return moderate(1e-9, 4, occlusion, contrast) && !(std::abs(bias) > 0.8 && std::abs(bias) < 1.6);
         })}));
}

void append_hbao_simplified(Entries& entries) {
    using Contribution = float(glm::vec3, glm::vec3, float, float);
    entries.push_back(equation<Contribution>(
        {.id = "CS-C-simplified",
         .function = "gloam_contribution_hbao_simplified",
         .file = hbao_file,
         .title = "NVIDIA's simplification of one tap of HBAO",
         .formula = "sat(n . v / |v| - bias) sat(1 - |v|^2 / R^2) / (1 - bias)",
         .source = "NVIDIA's sample gl_ssao"},
        &reference::gloam_contribution_hbao_simplified,
        {.domain = {offsets(), unit_vector(3).and_special(), radii(),
                    uniform(0, 0.5).and_near({0.0}).and_special()},
         .budget = {.absolute = 1e-6},
         .codomain = {0, 1},
         .promised = make_predicate<Contribution>([](glm::dvec3, glm::dvec3 n, double radius, double bias) {
             return moderate(1e-9, 2, n) && moderate(1e-12, 1e12, radius) && bias <= 0.5;
         })}));
    const Values sums = made_by<glm::vec2>([](numeric::Random& random) {
                            const auto n = static_cast<float>(1 + random.below(64));
                            return glm::vec2(n * static_cast<float>(random.uniform(0, 0.6)), n);
                        }).and_special();
    entries.push_back(equation<float(glm::vec2, float)>(
        {.id = "CS-C-simplified-visibility",
         .function = "gloam_visibility_hbao_simplified",
         .file = hbao_file,
         .title = "visibility from NVIDIA's simplification of HBAO",
         .formula = "sat(1 - 2 mean)^power",
         .source = "NVIDIA's sample gl_ssao"},
        &reference::gloam_visibility_hbao_simplified,
        {.domain = {sums, uniform(0.5, 4).and_near({1.0, 1.5}).and_special()},
         .budget = {.absolute = 1e-6, .backward_ulp = 2},
         .codomain = {0, 1},
         .promised = make_predicate<float(glm::vec2, float)>([](glm::dvec2 sum, double power) {
             return moderate(1e-9, 1e9, sum) && power >= 0.4 && power <= 4;
         })}));
}

}  // namespace

void append_horizons(Entries& entries) {
    append_tangents(entries);
    append_tangent_elevation(entries);
    append_hbao_horizon(entries);
    append_hbao_march(entries);
    append_hbao_step_size(entries);
    append_hbao_results(entries);
    append_hbao_simplified(entries);
}

}  // namespace gloam::catalogue
