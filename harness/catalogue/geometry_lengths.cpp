// SPDX-License-Identifier: MIT
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/relatives_parts.hpp"
#include "numeric/constants.hpp"
#include "reference/geometry.hpp"
#include "reference/geometry_camera.hpp"

namespace gloam::catalogue {

using namespace check;

namespace {

void append_curvatures(Entries& entries) {
    using Signature = glm::vec2(glm::vec3, glm::vec3, glm::vec3, glm::vec3);
    const Values step =
        either(vector_of_length(3, uniform(0.01, 0.02)), vector_of_length(3, log_uniform(1e-12, 1e12)))
            .and_value(glm::vec3(0))
            .and_special();
    const Values turn = either(vector_of_length(3, uniform(0, 0.01)), vector_of_length(3, uniform(0.8, 1)))
                            .and_value(glm::vec3(0))
                            .and_special();
    entries.push_back(equation<Signature>(
        {.id = "CS-K-principal",
         .function = "gloam_principal_curvatures",
         .file = "gloam/geometry/curvature.glsl",
         .title = "principal curvatures from neighbouring pixels",
         .formula = "eigenvalues of the shape operator, -dn = S dp",
         .source = "differential geometry"},
        &reference::gloam_principal_curvatures,
        {.domain = {step, step, turn, turn},
         .budget = {.absolute = 1.1e-4},
         .codomain = {-numeric::largest_float, numeric::largest_float},
         .promised =
             make_predicate<Signature>([](glm::dvec3 px, glm::dvec3 py, glm::dvec3 nx, glm::dvec3 ny) {
                 const double a = glm::length(px);
                 const double b = glm::length(py);
                 return a > 0.009 && a < 0.021 && b > 0.009 && b < 0.021 && glm::length(nx) < 1.1 &&
                        glm::length(ny) < 1.1 && glm::length(glm::cross(px, py)) > 0.8 * a * b;
             })}));
}

using Moments = reference::GloamSurfaceMoments;

bool usual_moments(const Moments& m) {
    return moderate(1e-9, 1e4, m.weight, m.mean, m.variance, m.covariance);
}

// Weight, mean, variances, covariances.
Values moments() {
    std::vector<Values> members{either(uniform(0.25, 64), constant(0.0F))};
    members.insert(members.end(), 3, uniform(-5, 5));
    members.insert(members.end(), 3, uniform(0, 2));
    members.insert(members.end(), 3, uniform(-1, 1));
    return vector(members).only_as_drawn();
}

void append_moments(Entries& entries) {
    constexpr const char* file = "gloam/geometry/surface_moments.glsl";
    constexpr const char* source = "Chan, Golub and LeVeque 1979";
    entries.push_back(equation<Moments()>({.id = "MOMENTS-empty",
                                           .function = "gloam_moments_empty",
                                           .file = file,
                                           .title = "moments of no surface point",
                                           .formula = "weight 0",
                                           .source = "definition"},
                                          &reference::gloam_moments_empty, {.codomain = {0, 0}}));
    entries.push_back(equation<Moments(glm::vec3)>(
        {.id = "MOMENTS-of",
         .function = "gloam_moments_of",
         .file = file,
         .title = "moments of one surface point",
         .formula = "weight 1, its mean, no variance",
         .source = "definition"},
        &reference::gloam_moments_of,
        {.domain = {vector(3, uniform(-5, 5)).only_as_drawn()}, .codomain = {-5, 5}}));
    entries.push_back(equation<Moments(Moments, Moments)>(
        {.id = "MOMENTS-add",
         .function = "gloam_moments_add",
         .file = file,
         .title = "moments of two groups of surface points",
         .formula = "m = m_a + t d;  C = (1 - t) C_a + t C_b + t (1 - t) d d^T,  d = m_b - m_a,  t = w_b / w",
         .source = source},
        &reference::gloam_moments_add,
        {.domain = {moments(), moments()},
         .budget = {.absolute = 2e-5},
         .codomain = {-128, 128},
         .promised = make_predicate<Moments(Moments, Moments)>(
             [](const Moments& a, const Moments& b) { return usual_moments(a) && usual_moments(b); })}));
    entries.push_back(equation<float(Moments, glm::vec3)>(
        {.id = "MOMENTS-along",
         .function = "gloam_moments_along",
         .file = file,
         .title = "variance of surface points along a direction",
         .formula = "max(n^T C n, 0)",
         .source = "definition"},
        &reference::gloam_moments_along,
        {.domain = {moments(), unit_vector(3).and_special()},
         .budget = {.absolute = 2e-6},
         .codomain = {0, numeric::infinity},
         .promised = make_predicate<float(Moments, glm::vec3)>([](const Moments& m, const glm::dvec3& n) {
             return usual_moments(m) && moderate(1e-9, 1.1, n);
         })}));
}

}  // namespace

void append_geometry_lengths(Entries& entries) {
    append_curvatures(entries);
    append_moments(entries);
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
        &reference::gloam_length,
        {.domain = {any},
         .budget = {.ulp = 4},
         .codomain = {0, numeric::infinity},
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
        &reference::gloam_radius_cap,
        {.domain = Domain{vector(2, radius), radius},
         .budget = {.ulp = 3.5},
         .codomain = {0, 3.5e38},
         .promised = make_predicate<glm::vec2(glm::vec2, float)>([](glm::dvec2 axes, double cap) {
             return moderate(1e-18, 1e18, axes, cap) && std::max(axes.x, axes.y) < 1e18;
         })}));
}

}  // namespace gloam::catalogue
