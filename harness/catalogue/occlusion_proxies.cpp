// SPDX-License-Identifier: MIT
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/relatives_parts.hpp"
#include "numeric/constants.hpp"
#include "reference/occlusion_points.hpp"
#include "reference/sampling.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr const char* sphere_file = "gloam/occlusion/sphere_proxy.glsl";
constexpr const char* disc_file = "gloam/occlusion/disc_proxy.glsl";
constexpr const char* aksoy_file = "gloam/occlusion/aksoy_phaneuf.glsl";
constexpr const char* song = "Shanmugam and Arikan 2007; Song 2010 (mixture sampling)";
constexpr const char* aksoy = "Aksoy and Phaneuf 2011, corrected";

Values offsets() {
    return either(vector_of_length(3, uniform(0, 2)), vector_of_length(3, log_uniform(1e-37, 1e38)))
        .and_value(glm::vec3(0))
        .and_special();
}
Values normals() {
    return unit_vector(3).and_special();
}
Values lengths() {
    return either(log_uniform(0.02, 2), log_uniform(1e-37, 1e38)).and_special();
}
// Neither a dot product overflows nor a length loses digits.
bool sized(glm::dvec3 v) {
    return !(std::abs(v.x) + std::abs(v.y) + std::abs(v.z) > 1e18) &&
           !(glm::length(v) < 1e-18 && v != glm::dvec3(0));
}

void append_spheres(Entries& entries) {
    entries.push_back(equation<float(float, float)>(
        {.id = "CS-H-fraction",
         .function = "gloam_sphere_fraction",
         .file = sphere_file,
         .title = "part of the half space that a ball takes up",
         .formula = "1 - sqrt(1 - (r / D)^2)",
         .source = "solid angle of a ball"},
        &reference::gloam_sphere_fraction,
        {.domain = Domain{lengths(), lengths()}.tied(1, 0).tied(1, 0, 1.0001),
         .budget = {.absolute = 3e-7},
         .codomain = {0, 1},
         .promised = make_predicate<float(float, float)>(
             [](double r, double d) { return !(r < 1e-30) && !(d < 1e-30); })}));
    using Signature = float(glm::vec3, glm::vec3, float);
    Question check{.domain = {offsets(), normals(), lengths()},
                   .budget = {.absolute = 8e-7},
                   .codomain = {0, 1},
                   .promised = make_predicate<Signature>([](glm::dvec3 v, glm::dvec3 n, double r) {
                       const double near = r / glm::length(v);
                       return sized(v) && is_unit(n) && !(r < 1e-18) && (near < 0.95 || near > 1.0001);
                   })};
    entries.push_back(equation<Signature>({.id = "CS-H",
                                           .function = "gloam_contribution_sphere",
                                           .file = sphere_file,
                                           .title = "contribution of a ball by its solid angle",
                                           .formula = "(1 - sqrt(1 - (r / D)^2)) max(n . v / D, 0)",
                                           .source = song},
                                          &reference::gloam_contribution_sphere, check));
    check.budget.absolute = 5e-7;
    entries.push_back(equation<Signature>({.id = "CS-H-cosine",
                                           .function = "gloam_contribution_sphere_cosine",
                                           .file = sphere_file,
                                           .title = "contribution of a ball, cosine-weighted",
                                           .formula = "(r / D)^2 max(n . v / D, 0)",
                                           .source = "derived: exact for a ball above the tangent plane"},
                                          &reference::gloam_contribution_sphere_cosine, check));
}

void append_horizon_test(Entries& entries) {
    using Above = float(glm::vec3, float);
    entries.push_back(equation<Above>(
        {.id = "CS-H-above",
         .function = "gloam_above_horizon",
         .file = sphere_file,
         .title = "whether a proxy stands above the horizon",
         .formula = "v_z > tan(h) |v_xy|",
         .source = "Song 2010 (mixture sampling)"},
        &reference::gloam_above_horizon,
        {.domain = {offsets(), either(uniform(-4, 4), any_float()).and_near({0.0}).and_special()},
         .budget = {.backward_ulp = 6},
         .codomain = {0, 1},
         .promised = make_predicate<Above>(
             [](glm::dvec3 v, double horizon) { return sized(v) && moderate(1e-9, 1e9, v, horizon); })}));
}

void append_discs(Entries& entries) {
    const Values area = either(log_uniform(1e-3, 10), log_uniform(1e-37, 1e38)).and_special();
    entries.push_back(equation<glm::vec2(float, float)>(
        {.id = "CS-S-share",
         .function = "gloam_disc_share",
         .file = disc_file,
         .title = "how a disc shares the squared distance to its rim",
         .formula = "(A, pi D^2) / (A + pi D^2)",
         .source = "derived"},
        &reference::gloam_disc_share,
        {.domain = {area, lengths()},
         .budget = {.absolute = 4e-7},
         .codomain = {0, 1},
         .promised = make_predicate<glm::vec2(float, float)>(
             [](double a, double d) { return !(a < 1e-30) && !(d < 1e-30); })}));
    using Signature = float(glm::vec3, glm::vec3, glm::vec3, float, float);
    const auto check = [&](double absolute) {
        return Question{.domain = {offsets(), normals(), normals(), area, uniform(0, 1).and_special()},
                        .budget = {.absolute = absolute},
                        .codomain = {0, 1},
                        .promised = make_predicate<Signature>(
                            [](glm::dvec3 v, glm::dvec3 n, glm::dvec3 e, double a, double) {
                                return sized(v) && is_unit(n) && is_unit(e) && !(a < 1e-30);
                            })};
    };
    entries.push_back(equation<Signature>(
        {.id = "CS-S",
         .function = "gloam_contribution_disc_proxy",
         .file = disc_file,
         .title = "contribution of a disc of the scene",
         .formula = "(1 - 1 / sqrt(1 + A / (pi D^2))) max(-n_E . v / D, 0) min(4 max(n . v / D, 0), 1)",
         .source = "Bunnell 2005 (GPU Gems 2, chapter 14)"},
        &reference::gloam_contribution_disc_proxy, check(8e-7)));
    entries.push_back(
        equation<Signature>({.id = "CS-S-cosine",
                             .function = "gloam_contribution_disc_proxy_cosine",
                             .file = disc_file,
                             .title = "contribution of a disc of the scene, cosine-weighted",
                             .formula = "A / (A + pi D^2) max(-n_E . v / D, 0) max(n . v / D, 0)",
                             .source = "derived: exact on the axis"},
                            &reference::gloam_contribution_disc_proxy_cosine, check(6e-7)));
}

void append_poisson(Entries& entries) {
    using Signature = float(glm::vec3, glm::vec3, float, float);
    entries.push_back(equation<Signature>(
        {.id = "CS-J",
         .function = "gloam_contribution_aksoy_phaneuf",
         .file = aksoy_file,
         .title = "contribution of a surface point in front of the tangent plane",
         .formula = "max(1 - |v| / R, 0) if v . n > bias, else 0",
         .source = aksoy},
        &reference::gloam_contribution_aksoy_phaneuf,
        {.domain = {offsets(), normals(), lengths(), either(uniform(0, 0.1), constant(0.0F)).and_special()},
         .budget = {.absolute = 4e-7, .backward_ulp = 4},
         .codomain = {0, 1},
         .promised = make_predicate<Signature>([](glm::dvec3 v, glm::dvec3 n, double r, double bias) {
             return sized(v) && is_unit(n) && !(r < 1e-18) &&
                    std::abs(glm::dot(v, n) - bias) > 1e-6 * glm::length(v);
         })}));
    const Values occlusion = uniform(0, 1).and_near({0.0, 1.0}).and_special();
    entries.push_back(equation<float(float, float)>(
        {.id = "CS-J-radii",
         .function = "gloam_two_radii_sum",
         .file = aksoy_file,
         .title = "occlusion from two radii",
         .formula = "min(fine + broad, 1)",
         .source = aksoy},
        &reference::gloam_two_radii_sum,
        {.domain = {occlusion, occlusion}, .budget = {.ulp = 0.5}, .codomain = {0, 1}}));
}

}  // namespace

void append_sampling_marches(Entries& entries) {
    using Signature = glm::vec3(glm::vec3, glm::vec3, float, int, int, float);
    entries.push_back(equation<Signature>(
        {.id = "CS-C2",
         .function = "gloam_eye_march",
         .file = "gloam/sampling/eye_march.glsl",
         .title = "point of a ray marched in eye space",
         .formula = "p + R (i + jitter) / N w",
         .source = "Dimitrov, Bavoil and Sainz 2008 (horizon-split AO)"},
        &reference::gloam_eye_march,
        {.domain = {vector(3, uniform(-8, 8)), normals(), either(uniform(0, 2), any_float()).and_special(),
                    either(integers(0, 16), integers(-2, 40)),
                    either(integers(1, 16), integers(-2, 100000000)), uniform(0, 1).and_special()},
         .budget = {.absolute = 1e-6},
         .codomain = {-numeric::largest_float, numeric::largest_float},
         .promised = make_predicate<Signature>([](glm::dvec3, glm::dvec3 w, double radius, int, int, double) {
             return moderate(0.0, 2, w) && !(radius > 2) && !(radius < -2);
         })}));
}

void append_occlusion_proxies(Entries& entries) {
    append_spheres(entries);
    append_horizon_test(entries);
    append_discs(entries);
    append_poisson(entries);
}

}  // namespace gloam::catalogue
