// SPDX-License-Identifier: MIT
// Methods of single points: Alchemy, ISSAO, Crytek, Filion and McNaughton.
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/occlusion_parts.hpp"
#include "reference/geometry_camera.hpp"
#include "reference/occlusion.hpp"
#include "reference/occlusion_points.hpp"
#include "reference/sampling.hpp"
#include "reference/shading.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr double float_max = 0x1.fffffep127;
constexpr const char* alchemy_source = "McGuire et al. 2011; Aalund and Baerentzen 2013, eqs 3.6 to 3.10";

Values offsets() {
    return either(vector_of_length(3, uniform(0.1, 3)), vector_of_length(3, log_uniform(1e-30, 1e30)))
        .and_value(glm::vec3(0))
        .and_special();
}
Values normals() {
    return unit_vector(3).and_special();
}
Values lengths() {
    return either(log_uniform(0.01, 10), log_uniform(1e-37, 1e38)).and_special();
}
Values biases() {
    return either(constant(0.0F), log_uniform(1e-4, 0.1)).and_special();
}
Values epsilons() {
    return either(log_uniform(1e-6, 1e-2), constant(0.0F)).and_special();
}
Values depths() {
    return either(uniform(0.5, 8), log_uniform(1e-3, 1e6)).and_near({0x1p-126, float_max}).and_special();
}
// Sums of the contributions of a few samples, and their number.
Values sums(double mean) {
    return made_by<glm::vec2>([mean](numeric::Random& random) {
               const auto n = static_cast<float>(1 + random.below(64));
               return glm::vec2(n * static_cast<float>(random.uniform(0, mean)), n);
           })
        .and_value(glm::vec2(0))
        .and_special();
}

// Offsets of at least a tenth of a unit. With them the sum and difference of products lose few digits.
bool ordinary(glm::dvec3 v) {
    const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return length == 0.0 || (length >= 0.1 && length <= 3.001);
}

void append_biases(Entries& entries) {
    entries.push_back(equation<float(float, float, float)>(
        {.id = "BIAS-depth",
         .function = "gloam_depth_bias",
         .file = "gloam/occlusion/bias.glsl",
         .title = "bias that grows with the depth",
         .formula = "b d / d_ref",
         .source = "McGuire et al. 2011; psi(z) of ISSAO, eq 6"},
        &reference::gloam_depth_bias,
        {.domain = {lengths(), depths(), lengths()},
         .budget = {.ulp = 2.5},
         .codomain = {0, float_max},
         .promised = make_predicate<float(float, float, float)>(
             [](double b, double d, double reference) { return moderate(1e-9, 1e9, b, d, reference); })}));
}

void append_alchemy(Entries& entries) {
    using Contribution = float(glm::vec3, glm::vec3, float, float);
    constexpr const char* file = "gloam/occlusion/alchemy.glsl";
    entries.push_back(equation<Contribution>(
        {.id = "CS-M",
         .function = "gloam_contribution_alchemy",
         .file = file,
         .title = "Alchemy's contribution of a surface point, in 1 / length",
         .formula = "C = max(v . n - bias, 0) / (v . v + epsilon)",
         .source = alchemy_source},
        &reference::gloam_contribution_alchemy,
        {.domain = {offsets(), normals(), biases(), epsilons()},
         .budget = {.absolute = 3e-6},
         .codomain = {0, float_max},
         .promised = make_predicate<Contribution>([](glm::dvec3 v, glm::dvec3 n, double bias, double) {
             return ordinary(v) && moderate(1e-9, 2, n) && bias >= 0 && bias <= 1;
         })}));
    entries.push_back(equation<float(glm::vec2, float, float)>(
        {.id = "CS-M-visibility",
         .function = "gloam_visibility_alchemy",
         .file = file,
         .title = "visibility from Alchemy's contributions",
         .formula = "max(0, 1 - (2 sigma / N) sum)^k",
         .source = alchemy_source},
        &reference::gloam_visibility_alchemy,
        {.domain = {sums(2), either(uniform(0, 1), lengths()).and_special(),
                    either(constant(1.0F), uniform(0.5, 4)).and_special()},
         .budget = {.absolute = 1e-6, .backward_ulp = 2},
         .codomain = {0, 1},
         .promised =
             make_predicate<float(glm::vec2, float, float)>([](glm::dvec2 sum, double sigma, double k) {
                 return moderate(1e-9, 1e9, sum, sigma) && k >= 0.4 && k <= 4;
             })}));
}

void append_issao_contributions(Entries& entries) {
    constexpr const char* file = "gloam/occlusion/issao.glsl";
    entries.push_back(equation<float(float, float, float)>(
        {.id = "ISSAO-5",
         .function = "gloam_issao_attenuation",
         .file = file,
         .title = "ISSAO's attenuation by distance",
         .formula = "Q = phi |v| / max(mu, |v|)^2",
         .source = "ISSAO, eq 5, reconstructed"},
        &reference::gloam_issao_attenuation,
        {.domain = Domain{lengths(), lengths(), lengths()}.tied(0, 2),
         .budget = {.ulp = 2.5},
         .codomain = {0, float_max},
         .promised = make_predicate<float(float, float, float)>(
             [](double d, double phi, double mu) { return moderate(1e-9, 1e9, d, phi, mu); })}));
    using Basic = float(glm::vec3, glm::vec3, float);
    entries.push_back(
        equation<Basic>({.id = "ISSAO-3",
                         .function = "gloam_contribution_issao_basic",
                         .file = file,
                         .title = "ISSAO's contribution of a direction, without attenuation",
                         .formula = "max(v . n / |v|, 0) for |v| < R",
                         .source = "ISSAO, eq 3, reconstructed"},
                        &reference::gloam_contribution_issao_basic,
                        {.domain = {offsets(), normals(), lengths()},
                         .budget = {.absolute = 4e-7},
                         .codomain = {0, 1},
                         .promised = make_predicate<Basic>([](glm::dvec3 v, glm::dvec3 n, double radius) {
                             return ordinary(v) && moderate(1e-9, 2, n) && moderate(1e-9, 1e9, radius);
                         })}));
    using Attenuated = float(glm::vec3, glm::vec3, float, float, float);
    entries.push_back(equation<Attenuated>(
        {.id = "ISSAO-4",
         .function = "gloam_contribution_issao_attenuated",
         .file = file,
         .title = "ISSAO's contribution of a direction",
         .formula = "Q(|v|) max(v . n / |v|, 0) for |v| < R",
         .source = "ISSAO, eq 4, reconstructed"},
        &reference::gloam_contribution_issao_attenuated,
        {.domain = {offsets(), normals(), lengths(), log_uniform(0.1, 1).and_special(),
                    log_uniform(0.2, 2).and_special()},
         .budget = {.absolute = 6e-7, .backward_ulp = 4},
         .codomain = {0, float_max},
         .promised =
             make_predicate<Attenuated>([](glm::dvec3 v, glm::dvec3 n, double radius, double phi, double mu) {
                 return ordinary(v) && moderate(1e-9, 2, n) && moderate(1e-9, 1e9, radius) && phi <= 1 &&
                        mu >= 0.2;
             })}));
}

void append_issao_taps(Entries& entries) {
    constexpr const char* file = "gloam/occlusion/issao.glsl";
    using Contribution = float(glm::vec3, glm::vec3, float, float, float, float);
    entries.push_back(equation<Contribution>(
        {.id = "ISSAO-6",
         .function = "gloam_contribution_issao",
         .file = file,
         .title = "ISSAO's contribution of a tap",
         .formula = "phi max(0, v . n - psi) / (v . v + sigma) for |v| < R",
         .source = "ISSAO, eq 6, reconstructed"},
        &reference::gloam_contribution_issao,
        {.domain = {offsets(), normals(), log_uniform(0.5, 4).and_special(),
                    log_uniform(0.1, 1).and_special(), biases(), epsilons()},
         .budget = {.absolute = 3e-6, .backward_ulp = 4},
         .codomain = {0, float_max},
         .promised = make_predicate<Contribution>(
             [](glm::dvec3 v, glm::dvec3 n, double radius, double phi, double bias, double) {
                 return ordinary(v) && moderate(1e-9, 2, n) && moderate(1e-9, 1e9, radius, bias) && phi <= 1;
             })}));
    entries.push_back(equation<float(glm::vec2, float)>(
        {.id = "ISSAO-6-mean",
         .function = "gloam_issao_occlusion",
         .file = file,
         .title = "ISSAO's occlusion factor",
         .formula = "A_0 = min((lambda / s) sum, 1)",
         .source = "ISSAO, eq 6, reconstructed"},
        &reference::gloam_issao_occlusion,
        {.domain = {sums(1.2), either(uniform(0.5, 1.5), lengths()).and_special()},
         .budget = {.ulp = 1.5},
         .codomain = {0, 1},
         .promised = make_predicate<float(glm::vec2, float)>(
             [](glm::dvec2 sum, double lambda) { return moderate(1e-9, 1e9, sum, lambda); })}));
}

void append_issao_samples(Entries& entries) {
    const Values unit = uniform(0, 1).and_near({0.25, 0.5, 0.75, 1.0}).and_special();
    const Values radius = uniform(0.5, 1).and_value(0.0F);
    const auto append_offset = [&](std::string id, std::string function, std::string title,
                                   std::string formula, auto reference, Budget budget) {
        entries.push_back(equation<glm::vec2(glm::vec2, float)>(
            {.id = std::move(id),
             .function = std::move(function),
             .file = "gloam/sampling/issao_offset.glsl",
             .title = std::move(title),
             .formula = std::move(formula),
             .source = "ISSAO, eq 1"},
            reference,
            {.domain = {vector(2, unit), radius}, .budget = budget, .codomain = {-1.000001, 1.000001}}));
    };
    append_offset("ISSAO-1", "gloam_issao_offset_polar", "sampling offset inside the disc",
                  "r_max e_1 (sin 2 pi e_2, cos 2 pi e_2)", &reference::gloam_issao_offset_polar,
                  {.absolute = 2e-7});
    append_offset("ISSAO-1-printed", "gloam_issao_offset_printed",
                  "sampling offset as printed, kept in the disc",
                  "r_max (e_1 sin 2 pi e_2, e_2 cos 2 pi e_1)", &reference::gloam_issao_offset_printed,
                  {.absolute = 3e-7});
    entries.push_back(equation<int(float, float, int, int)>(
        {.id = "ISSAO-LOD",
         .function = "gloam_count_by_radius",
         .file = "gloam/sampling/count_by_radius.glsl",
         .title = "number of samples by the projected size of the kernel",
         .formula = "clamp(round(most r / r_ref), least, most)",
         .source = "ISSAO, in prose"},
        &reference::gloam_count_by_radius,
        {.domain = Domain{either(uniform(0, 64), log_uniform(1e-37, 1e38)).and_special(),
                          either(uniform(16, 64), log_uniform(1e-37, 1e38)).and_special(), integers(0, 4),
                          integers(4, 64)}
                       .tied(0, 1)
                       .tied(0, 1, 0.5),
         .budget = {.backward_ulp = 2},
         .codomain = {0, 64}}));
}

void append_issao_light(Entries& entries) {
    entries.push_back(equation<glm::vec3(glm::vec3, float)>(
        {.id = "ISSAO-2",
         .function = "gloam_ambient_light",
         .file = "gloam/shading/ambient_light.glsl",
         .title = "ambient light that arrives",
         .formula = "I_a = I_0 (1 - A_0)",
         .source = "ISSAO, eq 2, reconstructed"},
        &reference::gloam_ambient_light,
        {.domain = {vector(3, uniform(0, 4)), uniform(0, 1).and_near({0.0, 1.0}).and_special()},
         .budget = {.ulp = 1.5},
         .codomain = {0, 4}}));
}

void append_covering_radii(Entries& entries) {
    using Covering = float(glm::vec3, float, float);
    const Values position = vector({uniform(-4, 4), uniform(-4, 4), uniform(-8, -0.5)}).and_special();
    const Values radius = either(uniform(0, 2), log_uniform(1e-30, 1e30)).and_special();
    const Values largest = either(uniform(0.5, 4), log_uniform(1e-30, 1e30)).and_special();
    // The disc is clear of the eye's plane, so the subtraction d - R sin t loses few digits.
    const auto usual = make_predicate<Covering>([](glm::dvec3 p, double radius, double) {
        const double along = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
        const bool clear = !(radius * std::hypot(p.x, p.y) > 0.5 * -p.z * along);
        return moderate(1e-9, 1e9, p, radius) && clear;
    });
    const auto append = [&](std::string id, std::string function, std::string title, std::string formula,
                            auto reference, Budget budget) {
        entries.push_back(equation<Covering>({.id = std::move(id),
                                              .function = std::move(function),
                                              .file = "gloam/geometry/covering_radius.glsl",
                                              .title = std::move(title),
                                              .formula = std::move(formula),
                                              .source = "ISSAO, section on the projected disc; derived"},
                                             reference,
                                             {.domain = {position, radius, largest},
                                              .budget = budget,
                                              .codomain = {0, float_max},
                                              .promised = usual}));
    };
    append("ISSAO-P-parallel", "gloam_covering_radius_parallel", "image of a disc parallel to the screen",
           "R / d", &reference::gloam_covering_radius_parallel, {.ulp = 1});
    append("ISSAO-P", "gloam_covering_radius_perpendicular",
           "circle that covers the image of a disc across the view ray", "R / (cos t (d - R sin t))",
           &reference::gloam_covering_radius_perpendicular, {.ulp = 8});
}

void append_crytek(Entries& entries) {
    constexpr const char* file = "gloam/occlusion/crytek.glsl";
    constexpr const char* source = "Mittring 2007; Aalund and Baerentzen 2013, eq 3.1";
    entries.push_back(
        equation<float(float, float)>({.id = "CS-A",
                                       .function = "gloam_contribution_crytek",
                                       .file = file,
                                       .title = "Crytek's contribution of a sample point",
                                       .formula = "1 - V', V' = 1 if s_d > s_z, else 0",
                                       .source = source},
                                      &reference::gloam_contribution_crytek,
                                      {.domain = Domain{depths(), depths()}.tied(1, 0), .codomain = {0, 1}}));
    const Values value = uniform(0, 1).and_near({0.0, 1.0}).and_special();
    entries.push_back(
        equation<float(float, float)>({.id = "CS-A-buffer",
                                       .function = "gloam_contribution_crytek_buffer",
                                       .file = file,
                                       .title = "Crytek's contribution by the values of a depth buffer",
                                       .formula = "1 - V', V' = 1 if s_d > s_z, else 0",
                                       .source = source},
                                      &reference::gloam_contribution_crytek_buffer,
                                      {.domain = Domain{value, value}.tied(1, 0), .codomain = {0, 1}}));
    using Sample = glm::vec3(glm::vec2, float, glm::vec3, float, float, float);
    entries.push_back(equation<Sample>(
        {.id = "CS-A-sample",
         .function = "gloam_crytek_sample",
         .file = file,
         .title = "Crytek's sample point in the space of the depth buffer",
         .formula = "(uv, b) + R (s.xy a, s.z b c), a = 1 / d, c = (100 / z_far) a",
         .source = "Aalund and Baerentzen 2013, published shader"},
        &reference::gloam_crytek_sample,
        {.domain = {vector(2, uniform(0, 1)), uniform(0, 1), vector_of_length(3, uniform(0, 1)),
                    log_uniform(0.1, 10), depths(), log_uniform(50, 2000).and_special()},
         .budget = {.ulp = 4, .absolute = 1e-6, .of_largest_component = true},
         .codomain = {-float_max, float_max},
         .promised =
             make_predicate<Sample>([](glm::dvec2, double, glm::dvec3, double, double depth, double z_far) {
                 return moderate(0.5, 1e9, depth) && moderate(1, 1e9, z_far);
             })}));
}

void append_filion(Entries& entries) {
    entries.push_back(equation<float(float, float, float)>(
        {.id = "CS-B",
         .function = "gloam_contribution_filion",
         .file = "gloam/occlusion/filion.glsl",
         .title = "contribution of a sample point, after Filion and McNaughton",
         .formula = "1 - clamp((D - R) / D, 0, 1), D = d_s - d_b > 0",
         .source = "Filion and McNaughton 2008"},
        &reference::gloam_contribution_filion,
        {.domain = Domain{depths(), depths(), lengths()}.tied(1, 0).tied(2, 0),
         .budget = {.absolute = 2e-7, .backward_ulp = 1},
         .codomain = {0, 1}}));
}

}  // namespace

void append_points(Entries& entries) {
    append_biases(entries);
    append_alchemy(entries);
    append_issao_contributions(entries);
    append_issao_taps(entries);
    append_issao_samples(entries);
    append_issao_light(entries);
    append_covering_radii(entries);
    append_crytek(entries);
    append_filion(entries);
}

}  // namespace gloam::catalogue
