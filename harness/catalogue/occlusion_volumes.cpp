// SPDX-License-Identifier: MIT
// Methods that pair opposite samples: volumetric obscurance and angle-based occlusion.
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/occlusion_parts.hpp"
#include "numeric/constants.hpp"
#include "reference/numeric.hpp"
#include "reference/occlusion_points.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr const char* volume_file = "gloam/occlusion/volumetric.glsl";
constexpr const char* volume_source = "Loos and Sloan 2010; Aalund and Baerentzen 2013, eq 3.5";
constexpr const char* tangent_sphere_source = "Szirmay-Kalos et al. 2009";
constexpr const char* angle_file = "gloam/occlusion/angle_based.glsl";
constexpr const char* angle_source = "Mittring 2012; Aalund and Baerentzen 2013";
constexpr double above_pi = 3.1415928;

Values offsets() {
    return either(vector_of_length(3, uniform(0.1, 1.5)), vector_of_length(3, log_uniform(1e-30, 1e30)))
        .and_value(glm::vec3(0))
        .and_special();
}
Values normals() {
    return unit_vector(3).and_special();
}
Values lengths() {
    return either(uniform(0.1, 2), log_uniform(1e-37, 1e38)).and_special();
}
Values cosines() {
    return either(uniform(-1.1, 1.1), signed_log_uniform(1e-30, 1e30))
        .and_near({-1.0, 0.0, 1.0})
        .and_special();
}

double length_of(glm::dvec3 v) {
    return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

void append_acos(Entries& entries) {
    const auto append = [&](std::string id, std::string function, std::string title, std::string formula,
                            auto reference, Budget budget, Codomain codomain) {
        entries.push_back(equation<float(float)>(
            {.id = std::move(id),
             .function = std::move(function),
             .file = "gloam/numeric/acos_approximation.glsl",
             .title = std::move(title),
             .formula = std::move(formula),
             .source = angle_source},
            reference, {.domain = {cosines()}, .budget = budget, .codomain = codomain}));
    };
    append("CS-P-cosine", "gloam_clamp_cosine", "cosine taken into its range", "clamp(x, -1, 1)",
           &reference::gloam_clamp_cosine, {}, {-1, 1});
    append("CS-P-acos-linear", "gloam_acos_linear", "arc cosine, linear approximation", "pi (1 - x) / 2",
           &reference::gloam_acos_linear, {.absolute = 3.5e-7}, {0, above_pi});
    append("CS-P-acos-quadratic", "gloam_acos_quadratic", "arc cosine, quadratic approximation",
           "pi (1 - sgn(x) x^2) / 2", &reference::gloam_acos_quadratic, {.absolute = 4e-7}, {0, above_pi});
    append("CS-P-acos-cubic", "gloam_acos_cubic", "arc cosine, cubic approximation",
           "((-2 pi / 9) x^2 - 5 pi / 18) x + pi / 2", &reference::gloam_acos_cubic, {.absolute = 4e-7},
           {0, above_pi});
}

void append_lines(Entries& entries) {
    entries.push_back(equation<float(glm::vec2, float)>(
        {.id = "CS-I-chord",
         .function = "gloam_chord_half_height",
         .file = volume_file,
         .title = "half the chord of the sphere at a tap",
         .formula = "h = r (1 - |xi|^2)^(1/2)",
         .source = volume_source},
        &reference::gloam_chord_half_height,
        {.domain = {vector_of_length(2, uniform(0, 1.1)).and_special(), uniform(0.1, 2).and_special()},
         .budget = {.absolute = 8e-7},
         .codomain = {0, numeric::infinity},
         .promised = make_predicate<float(glm::vec2, float)>([](glm::dvec2 xi, double radius) {
             const double squared = xi.x * xi.x + xi.y * xi.y;
             return !(squared > 0.99 && squared < 1.01) && moderate(1e-9, 2.1, radius);
         })}));
    entries.push_back(equation<float(float, float)>(
        {.id = "CS-I",
         .function = "gloam_line_occlusion",
         .file = volume_file,
         .title = "solid part of a chord",
         .formula = "q = clamp((h + z_s - z_p) / (2 h), 0, 1)",
         .source = volume_source},
        &reference::gloam_line_occlusion,
        {.domain = Domain{either(uniform(-2, 2), signed_log_uniform(1e-37, 1e38)).and_special(), lengths()}
                       .tied(0, 1)
                       .tied(0, 1, -1.0),
         .budget = {.absolute = 1.2e-7},
         .codomain = {0, 1}}));
    entries.push_back(equation<float(float, float)>(
        {.id = "CS-I-ratio",
         .function = "gloam_line_ratio",
         .file = volume_file,
         .title = "where the surface at a tap lies along the chord",
         .formula = "q* = (h + z_s - z_p) / (2 h)",
         .source = volume_source},
        &reference::gloam_line_ratio,
        {.domain = Domain{either(uniform(-2, 2), signed_log_uniform(1e-37, 1e38)).and_special(), lengths()}
                       .tied(0, 1)
                       .tied(0, 1, -1.0),
         .budget = {.ulp = 1.5, .absolute = 2e-7},
         .promised = make_predicate<float(float, float)>([](double height, double half_height) {
             return !std::isfinite(height) || !(std::abs(height) > 1e38 * half_height);
         })}));
    const Values fraction = uniform(-1, 2).and_near({0.35, 0.5, 1.0}).and_special();
    entries.push_back(equation<glm::vec2(glm::vec2, float, float)>(
        {.id = "CS-I-pair",
         .function = "gloam_line_pair",
         .file = volume_file,
         .title = "pair of opposite taps, a disbelieved one replaced",
         .formula = "q_i where lowest <= q_i <= highest, else 1 - q_j, else 1/2",
         .source = volume_source},
        &reference::gloam_line_pair,
        {.domain = {vector(2, fraction), uniform(0.2, 0.5).and_near({0.35}).and_special(),
                    uniform(0.8, 1).and_near({1.0}).and_special()},
         .budget = {.ulp = 0.5, .absolute = 0x1p-126}}));
}

void append_areas_and_balls(Entries& entries) {
    using Area = float(float, float, float);
    entries.push_back(equation<Area>(
        {.id = "CS-I-area",
         .function = "gloam_area_occlusion",
         .file = volume_file,
         .title = "solid part of a chord over an area of heights",
         .formula = "(1 / (2 w)) integral of clamp((h + z) / (2 h), 0, 1) dz over [m - w, m + w]",
         .source = "Loos and Sloan 2010, reconstructed"},
        &reference::gloam_area_occlusion,
        {.domain = Domain{either(uniform(-2, 2), signed_log_uniform(1e-37, 1e38)).and_special(),
                          either(uniform(0, 2), lengths()).and_value(0.0F), lengths()}
                       .tied(0, 2)
                       .tied(0, 1)
                       .tied(1, 2),
         .budget = {.absolute = 2e-7},
         .codomain = {0, 1}}));
    const Values solid = uniform(0, 1).and_near({0.0, 0.5, 1.0}).and_special();
    entries.push_back(equation<float(float, float)>(
        {.id = "CS-I-two-balls",
         .function = "gloam_two_balls",
         .file = volume_file,
         .title = "balls of two radii as one occlusion",
         .formula = "clamp(q_fine + q_broad - 1/2, 0, 1)",
         .source = "after Loos and Sloan 2010"},
        &reference::gloam_two_balls,
        {.domain = {solid, solid}, .budget = {.absolute = 1.2e-7}, .codomain = {0, 1}}));
}

void append_tangent_sphere(Entries& entries) {
    using Line = float(glm::vec3, glm::vec3, float);
    // Not near the outline of the sphere.
    const auto inside = make_predicate<Line>([](glm::dvec3 v, glm::dvec3 n, double radius) {
        const glm::dvec2 xi(v.x / (0.5 * radius) - n.x, v.y / (0.5 * radius) - n.y);
        const double squared = xi.x * xi.x + xi.y * xi.y;
        return moderate(0.1, 2.1, radius) && length_of(v) < 2 && length_of(n) < 1.1 &&
               (squared < 0.9 || squared > 1.1);
    });
    const Domain domain{either(vector_of_length(3, uniform(0, 0.6)), offsets()), normals(),
                        either(uniform(0.5, 2), lengths())};
    const auto append = [&](std::string id, std::string function, std::string title, std::string formula,
                            auto reference, Budget budget, Codomain codomain) {
        entries.push_back(equation<Line>(
            {.id = std::move(id),
             .function = std::move(function),
             .file = volume_file,
             .title = std::move(title),
             .formula = std::move(formula),
             .source = tangent_sphere_source},
            reference, {.domain = domain, .budget = budget, .codomain = codomain, .promised = inside}));
    };
    append("CS-I-tangent-chord", "gloam_tangent_sphere_half_height", "half the chord of the tangent sphere",
           "(r / 2) (1 - |2 v.xy / r - n.xy|^2)^(1/2)", &reference::gloam_tangent_sphere_half_height,
           {.absolute = 4e-7}, {0, 1e38});
    append("CS-I-tangent", "gloam_tangent_sphere_occlusion", "solid part of a chord of the tangent sphere",
           "q of the sphere of radius r / 2 around p + n r / 2", &reference::gloam_tangent_sphere_occlusion,
           {.absolute = 5e-7}, {0, 1});
}

// Whether an offset's direction is not close to -n, where its part in the tangent plane has no direction.
bool clear_of_nadir(glm::dvec3 v, glm::dvec3 n) {
    const double length = length_of(v);
    if (length == 0.0) return true;
    const double above = (v.x * n.x + v.y * n.y + v.z * n.z) / length;
    return above > -0.95 && moderate(1e-9, 2, n);
}

void append_angle_pairs(Entries& entries) {
    using Lifted = float(glm::vec3, glm::vec3, glm::vec3);
    entries.push_back(equation<Lifted>(
        {.id = "CS-P-lifted",
         .function = "gloam_lifted_cosine",
         .file = angle_file,
         .title = "cosine of a sample's angle to the view vector, no lower than the tangent plane",
         .formula = "view . s, s lifted to s - (s . n) n where s . n < 0",
         .source = angle_source},
        &reference::gloam_lifted_cosine,
        {.domain = {offsets(), normals(), unit_vector(3)},
         .budget = {.absolute = 5e-7},
         .codomain = {-1, 1},
         .promised = make_predicate<Lifted>(
             [](glm::dvec3 v, glm::dvec3 n, glm::dvec3) { return clear_of_nadir(v, n); })}));
    entries.push_back(equation<bool(glm::vec3, float)>(
        {.id = "CS-P-near",
         .function = "gloam_sample_near",
         .file = angle_file,
         .title = "whether a sample may belong to the same object",
         .formula = "z_s - z_p <= T",
         .source = angle_source},
        &reference::gloam_sample_near, {.domain = {offsets(), uniform(0, 2).and_special()}}));
    using Pair = glm::vec3(glm::vec3, glm::vec3, glm::vec3, glm::vec3, float);
    entries.push_back(equation<Pair>(
        {.id = "CS-P-pair",
         .function = "gloam_angle_pair",
         .file = angle_file,
         .title = "cosines and weight of a pair of opposite samples",
         .formula = "(c_1, c_2, w), an invalid one max(-view . s_j, 0)",
         .source = angle_source},
        &reference::gloam_angle_pair,
        {.domain = {offsets(), offsets(), normals(), unit_vector(3), uniform(0, 2).and_special()},
         .budget = {.absolute = 5e-7},
         .codomain = {-1, 1},
         .promised = make_predicate<Pair>([](glm::dvec3 a, glm::dvec3 b, glm::dvec3 n, glm::dvec3, double) {
             return clear_of_nadir(a, n) && clear_of_nadir(b, n);
         })}));
}

void append_angle_means(Entries& entries) {
    entries.push_back(equation<glm::vec2(glm::vec2, float, float)>(
        {.id = "CS-P-add",
         .function = "gloam_angle_add",
         .file = angle_file,
         .title = "one more pair in the angle-based occlusion",
         .formula = "(sum + w (1 - (a_1 + a_2) / pi), weight + w)",
         .source = angle_source},
        &reference::gloam_angle_add,
        {.domain = {vector(2, uniform(0, 8)), uniform(0, 1).and_near({0.0, 1.0}).and_special(),
                    uniform(0, 6.2831853).and_special()},
         .budget = {.absolute = 8e-7},
         .promised =
             make_predicate<glm::vec2(glm::vec2, float, float)>([](glm::dvec2, double weight, double angles) {
                 return weight <= 1 && std::abs(angles) <= 7;
             })}));
    const Values sum = vector({uniform(-1, 4), uniform(0, 8)}).and_value(glm::vec2(0)).and_special();
    entries.push_back(equation<float(glm::vec2)>(
        {.id = "CS-P",
         .function = "gloam_angle_occlusion",
         .file = angle_file,
         .title = "angle-based occlusion of all pairs",
         .formula = "max(sum / weight, 0)",
         .source = angle_source},
        &reference::gloam_angle_occlusion,
        {.domain = {sum}, .budget = {.ulp = 0.5, .absolute = 1e-37}, .codomain = {0, 1}}));
}

void append_unreal(Entries& entries) {
    using Contribution = float(glm::vec3, glm::vec3, float);
    constexpr const char* source = "Unreal Engine 4, as ported";
    entries.push_back(equation<Contribution>(
        {.id = "CS-P-unreal",
         .function = "gloam_contribution_unreal",
         .file = angle_file,
         .title = "a step along one side in the engine's later shader",
         .formula = "sat(scale (v . n) / (v . v))",
         .source = source},
        &reference::gloam_contribution_unreal,
        {.domain = {offsets(), normals(), uniform(0.1, 1).and_special()},
         .budget = {.absolute = 5e-7},
         .codomain = {0, 1},
         .promised = make_predicate<Contribution>([](glm::dvec3 v, glm::dvec3 n, double scale) {
             const double length = length_of(v);
             return (length == 0.0 || length >= 0.1) && length < 1e9 && moderate(1e-9, 2, n) && scale <= 1;
         })}));
    entries.push_back(equation<float(float)>({.id = "CS-P-unreal-side",
                                              .function = "gloam_unreal_side",
                                              .file = angle_file,
                                              .title = "what a side leaves open in the engine's later shader",
                                              .formula = "(1 - occ)^2",
                                              .source = source},
                                             &reference::gloam_unreal_side,
                                             {.domain = {uniform(0, 1).and_near({0.0, 1.0}).and_special()},
                                              .budget = {.ulp = 2},
                                              .codomain = {0, 1}}));
    using Visibility = float(float, float, float);
    entries.push_back(equation<Visibility>(
        {.id = "CS-P-unreal-visibility",
         .function = "gloam_unreal_visibility",
         .file = angle_file,
         .title = "visibility in the engine's later shader",
         .formula = "1 - (1 - AO^power) intensity",
         .source = source},
        &reference::gloam_unreal_visibility,
        {.domain = {uniform(0, 1).and_special(), uniform(0.5, 4).and_near({1.0}).and_special(),
                    uniform(0, 1).and_near({1.0}).and_special()},
         .budget = {.absolute = 1e-6, .backward_ulp = 2},
         .codomain = {0, 1},
         .promised = make_predicate<Visibility>([](double ao, double power, double intensity) {
             return moderate(1e-9, 2, ao, intensity) && power >= 0.4 && power <= 4;
         })}));
}

}  // namespace

void append_volumes(Entries& entries) {
    append_acos(entries);
    append_lines(entries);
    append_areas_and_balls(entries);
    append_tangent_sphere(entries);
    append_angle_pairs(entries);
    append_angle_means(entries);
    append_unreal(entries);
}

}  // namespace gloam::catalogue
