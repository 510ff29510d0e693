// SPDX-License-Identifier: MIT
// Falloffs, estimates, and the contributions of single points: Ritschel, Fox and Compton, Alchemy, ISSAO,
// Crytek, Filion and McNaughton.
#include <cmath>

#include "catalogue/inputs.hpp"
#include "numeric/numbers.hpp"
#include "reference/geometry_camera.hpp"
#include "reference/occlusion.hpp"
#include "reference/occlusion_points.hpp"
#include "reference/sampling.hpp"
#include "reference/shading.hpp"

namespace gloam::catalogue {
namespace {

using namespace judge;
using namespace subject;

// Distances and radii of any size. Half of them are within a factor of two of each other, where a falloff
// changes most.
Domain distances() {
    const Values length = either(log_uniform(0.5, 2), signed_log_uniform(1e-37, 1e38))
                              .and_near({0x1p-126, numeric::largest_float, 0x1p-64, 0x1p64})
                              .and_special();
    return Domain{length, length}.tied(0, 1).tied(0, 1, -1.0).tied(0, 1, 0.5).tied(0, 1, 5.541263545);
}

void add_falloff(Entries& entries, const char* id, double (*reference)(double, double), Budget budget) {
    add(entries, id, reference, distances(), budget, {0, 1});
}

Values depths() {
    return either(uniform(0.5, 8), log_uniform(1e-3, 1e6)).and_near({0x1p-126, 0x1.fffffep127}).and_special();
}

// Those that methods pass on: of surfaces in front of the eye.
Values finite_offsets() {
    return either(vector_of_length(3, uniform(0.1, 3)), vector_of_length(3, log_uniform(1e-18, 1e18)));
}

void append_hemispheres(Entries& entries) {
    add(entries, "TSSAO-1-cos", &reference::gloam_sample_cosine,
        {offsets_of(uniform(0, 2), log_uniform(1e-37, 1e38)), normals()}, {.absolute = 3e-7}, {0, 1},
        [](glm::dvec3, glm::dvec3 n) { return small(n, 1e38); });
    const Values slack = either(log_uniform(1e-4, 1), uniform(0, 1)).and_special();
    add(entries, "TSSAO-3-V", &reference::gloam_sample_blocked,
        Domain{depths(), depths(), slack, slack}.tied(1, 0).tied(3, 2), {.backward_ulp = 1});
    const Values factor =
        either(uniform(0, 1).and_near({0.0, 1.0}), signed_log_uniform(1e-30, 10)).and_special();
    const Domain three{factor, factor, factor};
    add(entries, "TSSAO-3", &reference::gloam_contribution_ritschel, three, {.ulp = 1.5}, {0, 1});
    add(entries, "TSSAO-3-uniform", &reference::gloam_contribution_uniform_directions, three, {.ulp = 1.5},
        {0, 2});
    add(entries, "TSSAO-12", &reference::gloam_contribution_fox_compton,
        {finite_offsets(), unit_vector(3), either(log_uniform(0.01, 10), log_uniform(1e-15, 1e15))},
        {.absolute = 3.5e-7}, {0, 1},
        [](glm::dvec3 v, glm::dvec3, double) { return moderate(1e-15, 1e15, glm::length(v)); });
    add(entries, "TSSAO-12-unscaled", &reference::gloam_contribution_fox_compton_unscaled,
        {finite_offsets(), unit_vector(3), either(log_uniform(0.1, 10), log_uniform(1e-15, 1e15))},
        {.absolute = 4e-6}, {0, 1.01e15}, [](glm::dvec3 v, glm::dvec3, double epsilon) {
            return epsilon >= 0.1 && moderate(1e-15, 1e15, glm::length(v));
        });
    const Values count = made_by<glm::vec2>([](numeric::Random& random) {
        const auto n = static_cast<float>(random.below(1000));
        return glm::vec2(n * static_cast<float>(random.uniform(0, 1.2)), n);
    });
    add(entries, "TSSAO-2-add", &reference::gloam_estimator_add,
        {count, either(uniform(0, 2), any_float()).and_special()}, {.ulp = 0.5},
        {-numeric::largest_float, numeric::largest_float});
    add(entries, "TSSAO-2", &reference::gloam_estimator_mean, {count.and_value(glm::vec2(0)).and_special()},
        {.ulp = 2.5}, {0, 1});
}

Values point_offsets() {
    return offsets_of(uniform(0.1, 3), log_uniform(1e-30, 1e30));
}

Values lengths() {
    return either(log_uniform(0.01, 10), log_uniform(1e-37, 1e38)).and_special();
}

// Offsets of at least a tenth of a unit. With them the sum and difference of products lose few digits.
bool ordinary(glm::dvec3 v) {
    const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return length == 0.0 || (length >= 0.1 && length <= 3.001);
}

void append_alchemy(Entries& entries) {
    add(entries, "BIAS-depth", &reference::gloam_depth_bias, {lengths(), depths(), lengths()}, {.ulp = 2.5},
        {0, numeric::largest_float},
        [](double b, double d, double reference) { return moderate(1e-9, 1e9, b, d, reference); });
    add(entries, "CS-M", &reference::gloam_contribution_alchemy,
        {finite_offsets(), unit_vector(3), either(constant(0.0F), log_uniform(1e-4, 0.1)).and_special(),
         log_uniform(1e-6, 1e-2), uniform(0.1, 2)},
        {.absolute = 3e-6}, {0, numeric::infinity},
        [](glm::dvec3 v, glm::dvec3, double bias, double, double scale) {
            return ordinary(v) && bias >= 0 && bias <= 1 && scale <= 1;
        });
}

void append_issao_contributions(Entries& entries) {
    add(entries, "ISSAO-5", &reference::gloam_issao_attenuation,
        Domain{lengths(), lengths(), lengths()}.tied(0, 2), {.ulp = 5}, {0, numeric::largest_float},
        [](double d, double phi, double mu) { return moderate(1e-9, 1e9, d, phi, mu); });
    add(entries, "ISSAO-3", &reference::gloam_contribution_issao_basic,
        {point_offsets(), normals(), lengths()}, {.absolute = 4e-7, .backward_ulp = 4}, {0, 1},
        [](glm::dvec3 v, glm::dvec3 n, double radius) {
            return ordinary(v) && std::isfinite(glm::dot(n, n)) && moderate(1e-9, 2, n) &&
                   moderate(1e-9, 1e9, radius);
        });
    add(entries, "ISSAO-4", &reference::gloam_contribution_issao_attenuated,
        {point_offsets(), normals(), lengths(), log_uniform(0.1, 1).and_special(),
         log_uniform(0.2, 2).and_special()},
        {.absolute = 6e-7, .backward_ulp = 4}, {0, numeric::largest_float},
        [](glm::dvec3 v, glm::dvec3 n, double radius, double phi, double mu) {
            return ordinary(v) && moderate(1e-9, 2, n) && moderate(1e-9, 1e9, radius) && phi <= 1 &&
                   mu >= 0.2;
        });
    add(entries, "ISSAO-6", &reference::gloam_contribution_issao,
        {finite_offsets().only_as_drawn(), unit_vector(3).only_as_drawn(),
         log_uniform(0.5, 4).only_as_drawn(), log_uniform(0.1, 1).only_as_drawn(),
         either(constant(0.0F), log_uniform(1e-4, 0.1)).only_as_drawn(),
         log_uniform(1e-6, 1e-2).only_as_drawn()},
        {.absolute = 3e-6, .backward_ulp = 4}, {0, numeric::infinity},
        [](glm::dvec3 v, const auto&...) { return ordinary(v); });
    const Values sums = made_by<glm::vec2>([](numeric::Random& random) {
                            const auto n = static_cast<float>(1 + random.below(64));
                            return glm::vec2(n * static_cast<float>(random.uniform(0, 1.2)), n);
                        })
                            .and_value(glm::vec2(0))
                            .and_special();
    add(entries, "ISSAO-6-mean", &reference::gloam_issao_occlusion,
        {sums, either(uniform(0.5, 1.5), lengths()).and_special()}, {.ulp = 2.5}, {0, 1},
        [](glm::dvec2 sum, double lambda) { return moderate(1e-9, 1e9, sum, lambda); });
}

void append_issao_samples(Entries& entries) {
    const Values unit = uniform(0, 1).and_near({0.25, 0.5, 0.75, 1.0}).and_special();
    const Values radius = uniform(0.5, 1).and_value(0.0F);
    const Domain disc{vector(2, unit), radius};
    add(entries, "ISSAO-1", &reference::gloam_issao_offset_polar, disc, {.absolute = 2e-7},
        {-1.000001, 1.000001});
    add(entries, "ISSAO-1-printed", &reference::gloam_issao_offset_printed, disc, {.absolute = 3e-7},
        {-1.000001, 1.000001});
    add(entries, "ISSAO-LOD", &reference::gloam_count_by_radius,
        Domain{either(uniform(0, 64), log_uniform(1e-37, 1e38)).and_special(),
               either(uniform(16, 64), log_uniform(1e-37, 1e38)).and_special(), integers(0, 4),
               integers(4, 64)}
            .tied(0, 1)
            .tied(0, 1, 0.5),
        {.backward_ulp = 2}, {0, 64},
        [](double, double reference_radius, int, int) { return !(reference_radius > 0x1p126); });
    add(entries, "ISSAO-2", &reference::gloam_ambient_light, {vector(3, uniform(0, 4)), shares()},
        {.ulp = 1.5}, {0, 4});
    const Values position = vector({uniform(-4, 4), uniform(-4, 4), uniform(-8, -0.5)}).and_special();
    const Values reach = either(uniform(0, 2), log_uniform(1e-30, 1e30)).and_special();
    const Values largest = either(uniform(0.5, 4), log_uniform(1e-30, 1e30)).and_special();
    const Domain domain{position, reach, largest};
    // The disc is clear of the eye's plane, so the subtraction d - R sin t loses few digits.
    const auto usual = [](glm::dvec3 p, double r, double) {
        const double along = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
        const bool clear = !(r * std::hypot(p.x, p.y) > 0.5 * -p.z * along);
        return moderate(1e-9, 1e9, p, r) && clear;
    };
    add(entries, "ISSAO-P-parallel", &reference::gloam_covering_radius_parallel, domain, {.ulp = 2.5},
        {0, numeric::largest_float}, usual);
    add(entries, "ISSAO-P", &reference::gloam_covering_radius_perpendicular, domain, {.ulp = 8},
        {0, numeric::largest_float}, usual);
}

}  // namespace

void append_occlusion(Entries& entries) {
    add_falloff(entries, "FALLOFF-linear", &reference::gloam_falloff_linear, {.ulp = 3});
    add_falloff(entries, "FALLOFF-quadratic", &reference::gloam_falloff_quadratic, {.ulp = 4.5});
    add_falloff(entries, "FALLOFF-step", &reference::gloam_falloff_step, {});
    add_falloff(entries, "FALLOFF-exponential", &reference::gloam_falloff_exponential,
                {.ulp = 10, .backward_ulp = 4});
    add_falloff(entries, "FALLOFF-alchemy", &reference::gloam_falloff_alchemy, {.ulp = 2.5});
    append_hemispheres(entries);
    append_alchemy(entries);
    append_issao_contributions(entries);
    append_issao_samples(entries);
    add(entries, "CS-A", &reference::gloam_contribution_crytek, Domain{depths(), depths()}.tied(1, 0), {},
        {0, 1});
    add(entries, "CS-A-buffer", &reference::gloam_contribution_crytek_buffer,
        Domain{shares(), shares()}.tied(1, 0), {}, {0, 1});
    add(entries, "CS-A-sample", &reference::gloam_crytek_sample,
        {vector(2, uniform(0, 1)), uniform(0, 1), vector_of_length(3, uniform(0, 1)), log_uniform(0.1, 10),
         depths(), log_uniform(50, 2000).and_special()},
        {.ulp = 4, .absolute = 1e-6, .of_largest_component = true},
        {-numeric::largest_float, numeric::largest_float},
        [](glm::dvec2, double, glm::dvec3, double, double depth, double z_far) {
            return moderate(0.5, 1e9, depth) && moderate(1, 1e9, z_far);
        });
    add(entries, "CS-B", &reference::gloam_contribution_filion,
        Domain{log_uniform(1e-3, 1e6).only_as_drawn(), depths(), log_uniform(0.01, 10).only_as_drawn()}
            .tied(1, 0)
            .tied(2, 0),
        {.absolute = 2e-7, .backward_ulp = 1}, {0, 1});
}

}  // namespace gloam::catalogue
