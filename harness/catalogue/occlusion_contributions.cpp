// SPDX-License-Identifier: MIT
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/occlusion_parts.hpp"
#include "numeric/constants.hpp"
#include "reference/occlusion.hpp"
#include "reference/occlusion_points.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr const char* ritschel_file = "gloam/occlusion/ritschel.glsl";
constexpr const char* fox_compton_file = "gloam/occlusion/fox_compton.glsl";

Values depths() {
    return either(uniform(0.5, 8), log_uniform(1e-3, 1e6)).and_near({0x1p-126, 0x1.fffffep127}).and_special();
}
Values normals() {
    return unit_vector(3).and_special();
}
Values offsets() {
    return either(vector_of_length(3, uniform(0, 2)), vector_of_length(3, log_uniform(1e-37, 1e38)))
        .and_value(glm::vec3(0))
        .and_special();
}

// Whether a vector is short enough that its dot product with a unit vector cannot overflow.
bool short_enough(glm::dvec3 v) {
    return !(std::abs(v.x) + std::abs(v.y) + std::abs(v.z) > 1e38);
}

void append_tests(Entries& entries) {
    entries.push_back(equation<float(glm::vec3, glm::vec3)>(
        {.id = "TSSAO-1-cos",
         .function = "gloam_sample_cosine",
         .file = "gloam/occlusion/cosine.glsl",
         .title = "clamped cosine of a sample's angle to the normal",
         .formula = "max((s - p) . n / |s - p|, 0)",
         .source = "TSSAO (Mattausch et al.), eq 1 with the clamp it lacks in print"},
        &reference::gloam_sample_cosine,
        {.domain = {offsets(), normals()},
         .budget = {.absolute = 3e-7},
         .codomain = {0, 1},
         .promised = make_predicate<float(glm::vec3, glm::vec3)>(
             [](glm::dvec3, glm::dvec3 normal) { return short_enough(normal); })}));
    const Values slack = either(log_uniform(1e-4, 1), uniform(0, 1)).and_special();
    entries.push_back(equation<float(float, float, float, float)>(
        {.id = "TSSAO-3-V",
         .function = "gloam_sample_blocked",
         .file = "gloam/occlusion/blocked.glsl",
         .title = "whether the depth buffer blocks a sample point",
         .formula = "V = 1 if bias < d_s - d_b <= range, else 0",
         .source = "TSSAO (Mattausch et al.), eq 3 in screen space"},
        &reference::gloam_sample_blocked,
        {.domain = Domain{depths(), depths(), slack, slack}.tied(1, 0).tied(3, 2),
         .budget = {.backward_ulp = 1},
         .codomain = {0, 1}}));
}

void append_ritschel(Entries& entries) {
    const Values factor =
        either(uniform(0, 1).and_near({0.0, 1.0}), signed_log_uniform(1e-30, 10)).and_special();
    const Domain three{factor, factor, factor};
    entries.push_back(equation<float(float, float, float)>(
        {.id = "TSSAO-3",
         .function = "gloam_contribution_ritschel",
         .file = ritschel_file,
         .title = "contribution of a sample point, as printed",
         .formula = "C = V D max(cos, 0)",
         .source = "TSSAO (Mattausch et al.), eq 3; Ritschel et al. 2009"},
        &reference::gloam_contribution_ritschel,
        {.domain = three, .budget = {.ulp = 1.5}, .codomain = {0, 1}}));
    entries.push_back(equation<float(float, float)>(
        {.id = "TSSAO-3-cosine",
         .function = "gloam_contribution_cosine_directions",
         .file = ritschel_file,
         .title = "contribution of a sample point, cosine-weighted directions",
         .formula = "C = V D",
         .source = "TSSAO (Mattausch et al.), eq 3 normalised for density cos / pi"},
        &reference::gloam_contribution_cosine_directions,
        {.domain = {factor, factor}, .budget = {.ulp = 0.5}, .codomain = {0, 1}}));
    entries.push_back(equation<float(float, float, float)>(
        {.id = "TSSAO-3-uniform",
         .function = "gloam_contribution_uniform_directions",
         .file = ritschel_file,
         .title = "contribution of a sample point, uniform directions",
         .formula = "C = 2 V D max(cos, 0)",
         .source = "TSSAO (Mattausch et al.), eq 3 normalised for density 1 / (2 pi)"},
        &reference::gloam_contribution_uniform_directions,
        {.domain = three, .budget = {.ulp = 1.5}, .codomain = {0, 2}}));
}

void append_fox_compton(Entries& entries) {
    using Signature = float(glm::vec3, glm::vec3, glm::vec3, float);
    const Values position = either(vector(3, uniform(-8, 8)), vector(3, signed_log_uniform(1e-30, 1e37)))
                                .and_value(glm::vec3(0))
                                .and_special();
    const Values epsilon = either(log_uniform(0.01, 10), log_uniform(1e-30, 1e37)).and_special();
    const Domain domain{position, normals(), position, epsilon};
    entries.push_back(equation<Signature>(
        {.id = "TSSAO-12",
         .function = "gloam_contribution_fox_compton",
         .file = fox_compton_file,
         .title = "contribution of a surface patch, in 1 / length",
         .formula = "C = max(cos(s - p, n), 0) / max(epsilon, |s - p|)",
         .source = "TSSAO (Mattausch et al.), eq 12 corrected; Fox and Compton 2008"},
        &reference::gloam_contribution_fox_compton,
        {.domain = domain,
         .budget = {.absolute = 3e-6},
         .codomain = {0, 8.6e37},
         .promised = make_predicate<Signature>([](glm::dvec3 p, glm::dvec3 n, glm::dvec3 s, double epsilon) {
             return epsilon >= 0.1 && short_enough(n) && short_enough(p) && short_enough(s);
         })}));
    entries.push_back(equation<Signature>(
        {.id = "TSSAO-12-scaled",
         .function = "gloam_contribution_fox_compton_scaled",
         .file = fox_compton_file,
         .title = "contribution of a surface patch",
         .formula = "epsilon C = max(cos(s - p, n), 0) epsilon / max(epsilon, |s - p|)",
         .source = "TSSAO (Mattausch et al.), eq 12 corrected; Fox and Compton 2008"},
        &reference::gloam_contribution_fox_compton_scaled,
        {.domain = domain,
         .budget = {.absolute = 3e-7},
         .codomain = {0, 1},
         .promised = make_predicate<Signature>([](glm::dvec3 p, glm::dvec3 n, glm::dvec3 s, double) {
             return short_enough(n) && short_enough(p) && short_enough(s) && moderate(0x1p-126, 1e38, s - p);
         })}));
}

void append_estimator(Entries& entries) {
    constexpr const char* file = "gloam/occlusion/estimator.glsl";
    const Values count = made_by<glm::vec2>([](numeric::Random& random) {
        const auto n = static_cast<float>(random.below(1000));
        return glm::vec2(n * static_cast<float>(random.uniform(0, 1.2)), n);
    });
    entries.push_back(equation<glm::vec2(glm::vec2, float)>(
        {.id = "TSSAO-2-add",
         .function = "gloam_estimator_add",
         .file = file,
         .title = "one more contribution to a mean",
         .formula = "(sum + C, n + 1), C finite",
         .source = "TSSAO (Mattausch et al.), eqs 2 and 4"},
        &reference::gloam_estimator_add,
        {.domain = {count, either(uniform(0, 2), any_float()).and_special()},
         .budget = {.ulp = 0.5},
         .codomain = {-numeric::largest_float, numeric::largest_float}}));
    entries.push_back(equation<float(glm::vec2)>({.id = "TSSAO-2",
                                                  .function = "gloam_estimator_mean",
                                                  .file = file,
                                                  .title = "mean of the contributions",
                                                  .formula = "AO = (1 / n) sum of C(p, s_i)",
                                                  .source = "TSSAO (Mattausch et al.), eqs 2 and 4"},
                                                 &reference::gloam_estimator_mean,
                                                 {.domain = {count.and_value(glm::vec2(0)).and_special()},
                                                  .budget = {.ulp = 0.5},
                                                  .codomain = {0, 1}}));
}

void append_weighted_mean(Entries& entries) {
    constexpr const char* file = "gloam/occlusion/estimator.glsl";
    const Values weighted = either(vector(2, uniform(0, 4)), vector(2, log_uniform(1e-36, 1e38)))
                                .and_value(glm::vec2(0))
                                .and_special();
    entries.push_back(equation<float(glm::vec2)>(
        {.id = "MEAN-weighted",
         .function = "gloam_weighted_ratio",
         .file = file,
         .title = "weighted mean of contributions",
         .formula = "sum of w C / sum of w, inside [0, 1]",
         .source = "definition"},
        &reference::gloam_weighted_ratio,
        {.domain = {weighted}, .budget = {.ulp = 0.5, .absolute = 1e-44}, .codomain = {0, 1}}));
    entries.push_back(
        equation<glm::vec2(glm::vec2, unsigned)>({.id = "MEAN-samples",
                                                  .function = "gloam_estimator_of_weighted",
                                                  .file = file,
                                                  .title = "weighted mean as if of a number of samples",
                                                  .formula = "(n m, n)",
                                                  .source = "definition"},
                                                 &reference::gloam_estimator_of_weighted,
                                                 {.domain = {weighted, integers(0, 4096)},
                                                  .budget = {.ulp = 1.5, .absolute = 5e-35},
                                                  .codomain = {0, 4096}}));
}

}  // namespace

void append_contributions(Entries& entries) {
    append_tests(entries);
    append_ritschel(entries);
    append_fox_compton(entries);
    append_estimator(entries);
    append_weighted_mean(entries);
}

}  // namespace gloam::catalogue
