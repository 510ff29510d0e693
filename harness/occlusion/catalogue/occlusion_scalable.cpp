// SPDX-License-Identifier: MIT
// SAO and MSSAO, layers, separable occlusion, and balls and discs that represent the scene.
#include <cmath>

#include "catalogue/inputs.hpp"
#include "numeric/numbers.hpp"
#include "reference/occlusion.hpp"
#include "reference/occlusion_points.hpp"
#include "reference/sampling.hpp"

namespace gloam::catalogue {
namespace {

using namespace subject;

Values proxy_offsets() {
    return offsets_of(uniform(0, 2), log_uniform(1e-37, 1e38));
}

Values lengths() {
    return either(log_uniform(0.02, 2), log_uniform(1e-37, 1e38)).and_special();
}

void append_sao_and_curvature(Entries& entries) {
    add(entries, "CS-Q", &reference::gloam_contribution_sao,
        {vector_of_length(3, log_uniform(0.01, 1.5)), unit_vector(3),
         either(uniform(0.5, 1), log_uniform(0.1, 1e3)).and_near({0.5, 1.0}).and_special(),
         either(uniform(0, 0.1), constant(0.01F)).and_special(), log_uniform(0.01, 0.1), uniform(0.1, 5)},
        {.absolute = 1.5e-5}, {0, numeric::infinity},
        [](glm::dvec3, glm::dvec3, double radius, double bias, double, double) {
            return radius >= 0.5 && radius <= 2 && bias >= 0 && bias <= 4;
        });
    add(entries, "CS-F", &reference::gloam_contribution_mssao, {proxy_offsets(), normals(), lengths()},
        {.absolute = 7e-7}, {0, 1}, [](glm::dvec3 v, glm::dvec3 n, double radius) {
            return small(v) && is_unit(n) && !(radius < 1e-30);
        });
    add(entries, "CS-F-combine", &reference::gloam_mssao_combine, {shares(), shares()}, {.absolute = 2e-7},
        {0, 1});
    const Values slope = either(uniform(0, 4), log_uniform(1e-4, 4096));
    add(entries, "CS-K-bowl", &reference::gloam_occlusion_bowl, {slope, slope}, {.absolute = 4e-7}, {0, 1});
    const Values falling =
        made_by<float>([](numeric::Random& random) { return -std::exp(random.uniform(-9.2, 8.3)); });
    add(entries, "CS-K-saddle", &reference::gloam_occlusion_saddle, {slope, falling}, {.absolute = 8e-7},
        {0, 1});
    const Values curvature =
        either(signed_log_uniform(1e-3, 100), any_float()).and_near({0.0, 2.0}).and_special();
    add(entries, "CS-K", &reference::gloam_occlusion_curvature,
        {curvature, curvature, either(log_uniform(0.1, 2), any_float()).and_near({1.0}).and_special()},
        {.absolute = 8e-7}, {0, 1}, [](double a, double b, double radius) {
            return moderate(1e-18, 1e18, a, b, radius) && std::isfinite(radius);
        });
}

void append_depths_and_layers(Entries& entries) {
    const Values depth =
        either(uniform(0.5, 8), log_uniform(1e-3, 1e6)).and_near({0x1p-126, 0x1.fffffep127}).and_special();
    add(entries, "CS-REJ", &reference::gloam_tap_rejected,
        {depth, depth, either(log_uniform(1e-3, 10), constant(1.0F)).and_special()}, {.backward_ulp = 1});
    const Values plain = either(uniform(0.5, 8), uniform(-8, -0.5));
    const Values further = vector(3, plain);
    add(entries, "CS-LAYERS-depth", &reference::gloam_layer_depth, {plain, further, integers(0, 3)}, {},
        {-8, 8});
    add(entries, "CS-LAYERS-together", &reference::gloam_layers_add,
        {vector({uniform(0, 1), uniform(0, 1), booleans()}).only_as_drawn(), uniform(0, 1), vector(3, plain),
         uniform(0.5, 8), integers(0, 3), integers(1, 4)},
        {}, {0, 1});
    add(entries, "CS-O", &reference::gloam_separable_mean, {shares(), shares()}, {.ulp = 0.5}, {0, 1});
    const Values offset = offsets_of(uniform(0, 2), log_uniform(1e-20, 1e20));
    const Values length = either(log_uniform(1e-2, 10), any_float()).and_special();
    add(entries, "CS-O-weight", &reference::gloam_separable_weight, {offset, normals(), length, length},
        {.absolute = 5e-7, .backward_ulp = 2}, {0, 1},
        [](glm::dvec3 v, glm::dvec3 n, double sigma, double tolerance) {
            return moderate(1e-9, 1e9, v, n, sigma, tolerance);
        });
}

// Neither a dot product overflows nor a length loses digits.
bool sized(glm::dvec3 v) {
    return small(v) && !(glm::length(v) < 1e-18 && v != glm::dvec3(0));
}

}  // namespace

void append_occlusion_scalable(Entries& entries) {
    append_sao_and_curvature(entries);
    append_depths_and_layers(entries);
    add(entries, "CS-H-fraction", &reference::gloam_sphere_fraction,
        Domain{lengths(), lengths()}.tied(1, 0).tied(1, 0, 1.0001), {.absolute = 3e-7}, {0, 1},
        [](double r, double d) { return !(r < 1e-30) && !(d < 1e-30); });
    const auto sphere = [&](const char* id, auto reference, double absolute) {
        add(entries, id, reference, {proxy_offsets(), normals(), lengths()}, {.absolute = absolute}, {0, 1},
            [](glm::dvec3 v, glm::dvec3 n, double r) {
                const double near = r / glm::length(v);
                return sized(v) && is_unit(n) && !(r < 1e-18) && (near < 0.95 || near > 1.0001);
            });
    };
    sphere("CS-H", &reference::gloam_contribution_sphere, 8e-7);
    sphere("CS-H-cosine", &reference::gloam_contribution_sphere_cosine, 5e-7);
    add(entries, "CS-H-above", &reference::gloam_above_horizon,
        {proxy_offsets(), either(uniform(-4, 4), any_float()).and_near({0.0}).and_special()},
        {.backward_ulp = 6}, {0, 1},
        [](glm::dvec3 v, double horizon) { return sized(v) && moderate(1e-9, 1e9, v, horizon); });
    const Values area = either(log_uniform(1e-3, 10), log_uniform(1e-37, 1e38)).and_special();
    add(entries, "CS-S-share", &reference::gloam_disc_share, {area, lengths()}, {.absolute = 4e-7}, {0, 1},
        [](double a, double d) { return !(a < 1e-30) && !(d < 1e-30); });
    add(entries, "CS-S-cosine", &reference::gloam_contribution_disc_proxy_cosine,
        {proxy_offsets(), normals(), normals(), area, uniform(0, 1).and_special()}, {.absolute = 6e-7},
        {0, 1}, [](glm::dvec3 v, glm::dvec3 n, glm::dvec3 e, double a, double) {
            return sized(v) && is_unit(n) && is_unit(e) && !(a < 1e-30);
        });
    add(entries, "CS-J", &reference::gloam_contribution_aksoy_phaneuf,
        {vector_of_length(3, either(uniform(0, 2), log_uniform(1e-17, 1e17))), unit_vector(3),
         log_uniform(0.02, 2), either(uniform(0, 0.1), constant(0.0F))},
        {.absolute = 4e-7, .backward_ulp = 4}, {0, 1}, [](glm::dvec3 v, glm::dvec3 n, double, double bias) {
            return std::abs(glm::dot(v, n) - bias) > 1e-6 * glm::length(v);
        });
    add(entries, "CS-J-radii", &reference::gloam_two_radii_sum, {shares(), shares()}, {.ulp = 0.5}, {0, 1});
}

}  // namespace gloam::catalogue
