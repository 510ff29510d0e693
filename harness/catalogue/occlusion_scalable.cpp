// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "catalogue/inputs.hpp"
#include "catalogue/relatives_parts.hpp"
#include "reference/occlusion.hpp"
#include "reference/occlusion_points.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr const char* file = "gloam/occlusion/sao.glsl";
constexpr const char* sao = "McGuire, Mara and Luebke 2012 (Scalable Ambient Obscurance)";
constexpr const char* deep = "Mara, McGuire, Nowrouzezahrai and Luebke 2016 (deep G-buffers)";
constexpr double infinity = std::numeric_limits<double>::infinity();

Values offsets() {
    return either(vector_of_length(3, log_uniform(0.01, 1.5)), vector_of_length(3, log_uniform(1e-37, 1e38)))
        .and_value(glm::vec3(0))
        .and_special();
}
Values normals() {
    return unit_vector(3).and_special();
}
Values radii() {
    return either(uniform(0.5, 1), log_uniform(1e-20, 1e19)).and_near({0.5, 1.0}).and_special();
}
Values biases() {
    return either(uniform(0, 0.1), constant(0.01F)).and_special();
}
Values epsilons() {
    return either(either(constant(0.01F), log_uniform(0.01, 0.1)), log_uniform(1e-37, 1e37)).and_special();
}

// Scenes of usual size, for which the errors are stated.
template <class... V>
bool ordinary(double radius, const V&... values) {
    return radius >= 0.5 && radius <= 2 && moderate(1e-6, 4, values...);
}

// A dot product with it does not overflow.
bool small(glm::dvec3 v) {
    return !(std::abs(v.x) + std::abs(v.y) + std::abs(v.z) > 1e18);
}

void append_visibility(Entries& entries) {
    constexpr const char* visibility_file = "gloam/occlusion/visibility.glsl";
    const Values value = either(uniform(0, 1).and_near({0.0, 1.0}), any_float()).and_special();
    entries.push_back(equation<float(float)>(
        {.id = "VISIBILITY",
         .function = "gloam_visibility",
         .file = visibility_file,
         .title = "visibility that stands for an amount of occlusion",
         .formula = "clamp(1 - x, 0, 1)",
         .source = "definition"},
        &reference::gloam_visibility, {.domain = {value}, .budget = {.ulp = 0.5}, .codomain = {0, 1}}));
    entries.push_back(equation<float(float)>({.id = "VISIBILITY-clamp",
                                              .function = "gloam_visibility_clamp",
                                              .file = visibility_file,
                                              .title = "visibility kept inside its range",
                                              .formula = "clamp(v, 0, 1)",
                                              .source = "definition"},
                                             &reference::gloam_visibility_clamp,
                                             {.domain = {value}, .codomain = {0, 1}}));
}

void append_parts(Entries& entries) {
    const Values squares = either(uniform(0, 4), log_uniform(1e-37, 1e38)).and_special();
    entries.push_back(equation<float(float, float)>(
        {.id = "CS-Q-window",
         .function = "gloam_sao_window",
         .file = file,
         .title = "the part of the falloffs inside the radius",
         .formula = "max(1 - v^2 / r^2, 0)",
         .source = sao},
        &reference::gloam_sao_window,
        {.domain = {squares, radii()}, .budget = {.absolute = 3e-7, .backward_ulp = 1}, .codomain = {0, 1}}));
    using Height = float(glm::vec3, glm::vec3, float);
    entries.push_back(
        equation<Height>({.id = "CS-Q-height",
                          .function = "gloam_sao_height",
                          .file = file,
                          .title = "height over the tangent plane, less the bias",
                          .formula = "max(v . n - bias, 0)",
                          .source = sao},
                         &reference::gloam_sao_height,
                         {.domain = {offsets(), normals(), biases()},
                          .budget = {.absolute = 5e-7},
                          .codomain = {0, 0x1.fffffep127},
                          .promised = make_predicate<Height>([](glm::dvec3 v, glm::dvec3 n, double bias) {
                              return moderate(1e-18, 2, v, bias) && is_unit(n);
                          })}));
    using Quotient = float(float, float, float);
    entries.push_back(equation<Quotient>(
        {.id = "CS-Q-quotient",
         .function = "gloam_sao_quotient",
         .file = file,
         .title = "height over squared distance",
         .formula = "h / (v^2 + epsilon)",
         .source = sao},
        &reference::gloam_sao_quotient,
        {.domain = {either(uniform(0, 1), log_uniform(1e-37, 1e38)).and_special(), squares, epsilons()},
         .budget = {.ulp = 2},
         .codomain = {0, infinity},
         .promised = make_predicate<Quotient>([](double h, double vv, double epsilon) {
             return moderate(1e-18, 1e18, h, vv, epsilon) && vv + epsilon > 1e-30;
         })}));
}

struct Contribution {
    const char* id;
    const char* function;
    const char* title;
    const char* formula;
    Budget budget;
};

// The contributions that take an epsilon.
template <class Reference>
void append_divided(Entries& entries, const Contribution& c, const char* source, double most,
                    Reference reference) {
    using Signature = float(glm::vec3, glm::vec3, float, float, float);
    entries.push_back(equation<Signature>(
        {.id = c.id,
         .function = c.function,
         .file = file,
         .title = c.title,
         .formula = c.formula,
         .source = source},
        reference,
        {.domain = {offsets(), normals(), radii(), biases(), epsilons()},
         .budget = c.budget,
         .codomain = {0, most},
         .promised = make_predicate<Signature>([](glm::dvec3 v, glm::dvec3 n, double radius, double bias,
                                                  double epsilon) {
             return ordinary(radius, v, bias) && is_unit(n) && bias >= 0 && epsilon >= 0.0099 && epsilon <= 1;
         })}));
}

template <class Reference>
void append_undivided(Entries& entries, const Contribution& c, Reference reference) {
    using Signature = float(glm::vec3, glm::vec3, float, float);
    entries.push_back(equation<Signature>(
        {.id = c.id,
         .function = c.function,
         .file = file,
         .title = c.title,
         .formula = c.formula,
         .source = sao},
        reference,
        {.domain = {offsets(), normals(), radii(), biases()},
         .budget = c.budget,
         .codomain = {0, infinity},
         .promised = make_predicate<Signature>([](glm::dvec3 v, glm::dvec3 n, double radius, double bias) {
             return ordinary(radius, v, bias) && is_unit(n) && bias >= 0;
         })}));
}

void append_contributions_of_sao(Entries& entries) {
    append_divided(entries,
                   {.id = "CS-Q",
                    .function = "gloam_contribution_sao",
                    .title = "contribution of a surface point",
                    .formula = "(1 - v^2 / r^2)^3 max(v . n - bias, 0) / (v^2 + epsilon), |v| < r",
                    .budget = {.absolute = 3e-6}},
                   sao, infinity, &reference::gloam_contribution_sao);
    append_divided(entries,
                   {.id = "CS-Q-A",
                    .function = "gloam_contribution_sao_paper",
                    .title = "contribution without falloff, as in the paper",
                    .formula = "0.6 max(v . n - bias, 0) / (v^2 + epsilon), |v| < r",
                    .budget = {.absolute = 1.2e-6, .backward_ulp = 1}},
                   sao, infinity, &reference::gloam_contribution_sao_paper);
    append_undivided(entries,
                     {.id = "CS-Q-C",
                      .function = "gloam_contribution_sao_medium",
                      .title = "contribution of medium contrast",
                      .formula = "4 (1 - v^2 / r^2) max(v . n - bias, 0) / r^2, |v| < r",
                      .budget = {.absolute = 1.4e-6}},
                     &reference::gloam_contribution_sao_medium);
    append_undivided(entries,
                     {.id = "CS-Q-D",
                      .function = "gloam_contribution_sao_low",
                      .title = "contribution of low contrast",
                      .formula = "2 max(v . n - bias, 0) / r^2, |v| < r",
                      .budget = {.absolute = 1e-6, .backward_ulp = 1}},
                     &reference::gloam_contribution_sao_low);
    append_divided(entries,
                   {.id = "CS-Q-deep",
                    .function = "gloam_contribution_deep",
                    .title = "high-quality contribution of the deep G-buffer",
                    .formula = "(1 - v^2 / r^2) max(v . n - bias, 0) / sqrt(epsilon + v^2), |v| < r",
                    .budget = {.absolute = 5e-7}},
                   deep, 1.0, &reference::gloam_contribution_deep);
}

void append_combinations(Entries& entries) {
    using Signature = float(glm::vec2, float);
    const auto sums = [](double largest) {
        return made_by<glm::vec2>([largest](numeric::Random& random) {
            const double n = static_cast<double>(1 + random.below(64));
            return glm::vec2(n * random.uniform(0, largest), n);
        });
    };
    const Values sigma = either(uniform(0, 2), any_float()).and_near({1.0}).and_special();
    const auto usual = [](glm::dvec2 sum, double x) { return moderate(1e-9, 1e9, sum, x); };
    entries.push_back(equation<Signature>(
        {.id = "CS-Q-visibility",
         .function = "gloam_visibility_sao",
         .file = file,
         .title = "visibility from the sum of contributions",
         .formula = "max(0, 1 - 5 sigma sum / n)",
         .source = sao},
        &reference::gloam_visibility_sao,
        {.domain = {either(sums(0.3), vector(2, any_float())).and_value(glm::vec2(0)).and_special(), sigma},
         .budget = {.absolute = 3e-7},
         .codomain = {0, 1},
         .promised = make_predicate<Signature>(usual)}));
    const Values power = either(uniform(0.25, 4), constant(1.0F)).and_special();
    entries.push_back(equation<Signature>(
        {.id = "CS-Q-deep-visibility",
         .function = "gloam_visibility_deep",
         .file = file,
         .title = "visibility from the sum of high-quality contributions",
         .formula = "max(0, 1 - sqrt(3 sum / n))^power",
         .source = deep},
        &reference::gloam_visibility_deep,
        {.domain = {either(sums(0.4), vector(2, any_float())).and_value(glm::vec2(0)).and_special(), power},
         .budget = {.absolute = 1e-6, .backward_ulp = 4},
         .codomain = {0, 1},
         .promised = make_predicate<Signature>(
             [](glm::dvec2 sum, double p) { return moderate(1e-9, 1e9, sum) && p >= 1 && p <= 16; })}));
}

void append_levels(Entries& entries) {
    constexpr const char* mssao_file = "gloam/occlusion/mssao.glsl";
    using Signature = float(glm::vec3, glm::vec3, float);
    entries.push_back(equation<Signature>(
        {.id = "CS-F",
         .function = "gloam_contribution_mssao",
         .file = mssao_file,
         .title = "contribution of a surface point at one level",
         .formula = "(1 - min(1, (d / d_max)^2)) max(n . v / |v|, 0)",
         .source = "Hoang and Low 2012 (MSSAO)"},
        &reference::gloam_contribution_mssao,
        {.domain = {offsets(), normals(), radii()},
         .budget = {.absolute = 7e-7},
         .codomain = {0, 1},
         .promised = make_predicate<Signature>([](glm::dvec3 v, glm::dvec3 n, double radius) {
             return small(v) && is_unit(n) && !(radius < 1e-30);
         })}));
    const Values level = uniform(0, 1).and_near({0.0, 1.0}).and_special();
    entries.push_back(equation<float(float, float)>(
        {.id = "CS-F-combine",
         .function = "gloam_mssao_combine",
         .file = mssao_file,
         .title = "occlusion from that of all levels",
         .formula = "1 - (1 - max) (1 - mean)",
         .source = "Hoang and Low 2012 (MSSAO)"},
        &reference::gloam_mssao_combine,
        {.domain = {level, level}, .budget = {.absolute = 2e-7}, .codomain = {0, 1}}));
}

}  // namespace

void append_occlusion_scalable(Entries& entries) {
    append_visibility(entries);
    append_parts(entries);
    append_contributions_of_sao(entries);
    append_combinations(entries);
    append_levels(entries);
}

}  // namespace gloam::catalogue
