// SPDX-License-Identifier: MIT
// SAO and MSSAO, layers, separable occlusion, and balls and discs that represent the scene.
#include <cmath>
#include <limits>

#include "catalogue/inputs.hpp"
#include "reference/occlusion.hpp"
#include "reference/occlusion_points.hpp"
#include "reference/sampling.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

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

void append_parts(Entries& entries) {
    const Values value = either(uniform(0, 1).and_near({0.0, 1.0}), any_float()).and_special();
    add(entries, "VISIBILITY", &reference::gloam_visibility,
        {.domain = {value}, .budget = {.ulp = 0.5}, .codomain = {0, 1}});
    add(entries, "VISIBILITY-clamp", &reference::gloam_visibility_clamp,
        {.domain = {value}, .codomain = {0, 1}});
    const Values squares = either(uniform(0, 4), log_uniform(1e-37, 1e38)).and_special();
    add(entries, "CS-Q-window", &reference::gloam_sao_window,
        {.domain = {squares, radii()}, .budget = {.absolute = 3e-7, .backward_ulp = 1}, .codomain = {0, 1}});
    add(entries, "CS-Q-height", &reference::gloam_sao_height,
        {.domain = {offsets(), normals(), biases()},
         .budget = {.absolute = 5e-7},
         .codomain = {0, 0x1.fffffep127}},
        [](glm::dvec3 v, glm::dvec3 n, double bias) { return moderate(1e-18, 2, v, bias) && is_unit(n); });
    add(entries, "CS-Q-quotient", &reference::gloam_sao_quotient,
        {.domain = {either(uniform(0, 1), log_uniform(1e-37, 1e38)).and_special(), squares, epsilons()},
         .budget = {.ulp = 2},
         .codomain = {0, infinity}},
        [](double h, double vv, double epsilon) {
            return moderate(1e-18, 1e18, h, vv, epsilon) && vv + epsilon > 1e-30;
        });
}

// The contributions that take an epsilon.
using Divided = double (*)(glm::dvec3, glm::dvec3, double, double, double);
void add_divided(Entries& entries, const char* id, Divided reference, Budget budget, double most = infinity) {
    add(entries, id, reference,
        {.domain = {offsets(), normals(), radii(), biases(), epsilons()},
         .budget = budget,
         .codomain = {0, most}},
        [](glm::dvec3 v, glm::dvec3 n, double radius, double bias, double epsilon) {
            return ordinary(radius, v, bias) && is_unit(n) && bias >= 0 && epsilon >= 0.0099 && epsilon <= 1;
        });
}

using Undivided = double (*)(glm::dvec3, glm::dvec3, double, double);
void add_undivided(Entries& entries, const char* id, Undivided reference, Budget budget) {
    add(entries, id, reference,
        {.domain = {offsets(), normals(), radii(), biases()}, .budget = budget, .codomain = {0, infinity}},
        [](glm::dvec3 v, glm::dvec3 n, double radius, double bias) {
            return ordinary(radius, v, bias) && is_unit(n) && bias >= 0;
        });
}

void append_contributions_of_sao(Entries& entries) {
    add_divided(entries, "CS-Q", &reference::gloam_contribution_sao, {.absolute = 3e-6});
    add_divided(entries, "CS-Q-A", &reference::gloam_contribution_sao_paper,
                {.absolute = 1.2e-6, .backward_ulp = 1});
    add_undivided(entries, "CS-Q-C", &reference::gloam_contribution_sao_medium, {.absolute = 1.4e-6});
    add_undivided(entries, "CS-Q-D", &reference::gloam_contribution_sao_low,
                  {.absolute = 1e-6, .backward_ulp = 1});
    add_divided(entries, "CS-Q-deep", &reference::gloam_contribution_deep, {.absolute = 5e-7}, 1.0);
}

void append_combinations(Entries& entries) {
    const auto sums = [](double largest) {
        return made_by<glm::vec2>([largest](numeric::Random& random) {
            const double n = static_cast<double>(1 + random.below(64));
            return glm::vec2(n * random.uniform(0, largest), n);
        });
    };
    const Values sigma = either(uniform(0, 2), any_float()).and_near({1.0}).and_special();
    const auto usual = [](glm::dvec2 sum, double x) { return moderate(1e-9, 1e9, sum, x); };
    add(entries, "CS-Q-visibility", &reference::gloam_visibility_sao,
        {.domain = {either(sums(0.3), vector(2, any_float())).and_value(glm::vec2(0)).and_special(), sigma},
         .budget = {.absolute = 3e-7},
         .codomain = {0, 1}},
        usual);
    const Values power = either(uniform(0.25, 4), constant(1.0F)).and_special();
    add(entries, "CS-Q-deep-visibility", &reference::gloam_visibility_deep,
        {.domain = {either(sums(0.4), vector(2, any_float())).and_value(glm::vec2(0)).and_special(), power},
         .budget = {.absolute = 1e-6, .backward_ulp = 4},
         .codomain = {0, 1}},
        [](glm::dvec2 sum, double p) { return moderate(1e-9, 1e9, sum) && p >= 1 && p <= 16; });
    add(entries, "CS-F", &reference::gloam_contribution_mssao,
        {.domain = {offsets(), normals(), radii()}, .budget = {.absolute = 7e-7}, .codomain = {0, 1}},
        [](glm::dvec3 v, glm::dvec3 n, double radius) {
            return small(v) && is_unit(n) && !(radius < 1e-30);
        });
    const Values level = uniform(0, 1).and_near({0.0, 1.0}).and_special();
    add(entries, "CS-F-combine", &reference::gloam_mssao_combine,
        {.domain = {level, level}, .budget = {.absolute = 2e-7}, .codomain = {0, 1}});
}

void append_curvature(Entries& entries) {
    const Values slope = either(uniform(0, 4), log_uniform(1e-4, 4096));
    add(entries, "CS-K-bowl", &reference::gloam_occlusion_bowl,
        {.domain = {slope, slope}, .budget = {.absolute = 4e-7}, .codomain = {0, 1}});
    const Values falling =
        made_by<float>([](numeric::Random& random) { return -std::exp(random.uniform(-9.2, 8.3)); });
    add(entries, "CS-K-saddle", &reference::gloam_occlusion_saddle,
        {.domain = {slope, falling}, .budget = {.absolute = 8e-7}, .codomain = {0, 1}});
    const Values curvature =
        either(signed_log_uniform(1e-3, 100), any_float()).and_near({0.0, 2.0}).and_special();
    add(entries, "CS-K", &reference::gloam_occlusion_curvature,
        {.domain = {curvature, curvature,
                    either(log_uniform(0.1, 2), any_float()).and_near({1.0}).and_special()},
         .budget = {.absolute = 8e-7},
         .codomain = {0, 1}},
        [](double a, double b, double radius) {
            return moderate(1e-18, 1e18, a, b, radius) && std::isfinite(radius);
        });
}

void append_depths_and_layers(Entries& entries) {
    const Values depth =
        either(uniform(0.5, 8), log_uniform(1e-3, 1e6)).and_near({0x1p-126, 0x1.fffffep127}).and_special();
    add(entries, "CS-REJ", &reference::gloam_tap_rejected,
        {.domain = {depth, depth, either(log_uniform(1e-3, 10), constant(1.0F)).and_special()},
         .budget = {.backward_ulp = 1}});
    const Values plain = either(uniform(0.5, 8), uniform(-8, -0.5));
    const Values further = vector(3, plain);
    add(entries, "CS-LAYERS-depth", &reference::gloam_layer_depth,
        {.domain = {plain, further, integers(0, 3)}, .codomain = {-8, 8}});
    add(entries, "CS-LAYERS-together", &reference::gloam_layers_add,
        {.domain = {vector({uniform(0, 1), uniform(0, 1), booleans()}).only_as_drawn(), uniform(0, 1),
                    vector(3, plain), uniform(0.5, 8), integers(0, 3), integers(1, 4)},
         .codomain = {0, 1}});
    add(entries, "CS-LAYERS-blocked", &reference::gloam_layer_blocked,
        {.domain = Domain{depth, depth, depth}.tied(0, 1).tied(0, 2), .codomain = {0, 1}});
    const Values occlusion = uniform(0, 1).and_near({0.0, 1.0}).and_special();
    add(entries, "CS-LAYERS", &reference::gloam_layers_occlusion,
        {.domain = {occlusion, occlusion}, .codomain = {0, 1}});
    add(entries, "CS-O", &reference::gloam_separable_mean,
        {.domain = {occlusion, occlusion}, .budget = {.ulp = 0.5}, .codomain = {0, 1}});
    const Values offset =
        either(vector_of_length(3, uniform(0, 2)), vector_of_length(3, log_uniform(1e-20, 1e20)))
            .and_value(glm::vec3(0))
            .and_special();
    const Values length = either(log_uniform(1e-2, 10), any_float()).and_special();
    add(entries, "CS-O-weight", &reference::gloam_separable_weight,
        {.domain = {offset, unit_vector(3).and_special(), length, length},
         .budget = {.absolute = 5e-7, .backward_ulp = 2},
         .codomain = {0, 1}},
        [](glm::dvec3 v, glm::dvec3 n, double sigma, double tolerance) {
            return moderate(1e-9, 1e9, v, n, sigma, tolerance);
        });
}

void append_occlusion_layers(Entries& entries) {
    append_curvature(entries);
    append_depths_and_layers(entries);
}

Values proxy_offsets() {
    return either(vector_of_length(3, uniform(0, 2)), vector_of_length(3, log_uniform(1e-37, 1e38)))
        .and_value(glm::vec3(0))
        .and_special();
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
    add(entries, "CS-H-fraction", &reference::gloam_sphere_fraction,
        {.domain = Domain{lengths(), lengths()}.tied(1, 0).tied(1, 0, 1.0001),
         .budget = {.absolute = 3e-7},
         .codomain = {0, 1}},
        [](double r, double d) { return !(r < 1e-30) && !(d < 1e-30); });
    const auto sphere = [&](const char* id, auto reference, double absolute) {
        add(entries, id, reference,
            {.domain = {proxy_offsets(), normals(), lengths()},
             .budget = {.absolute = absolute},
             .codomain = {0, 1}},
            [](glm::dvec3 v, glm::dvec3 n, double r) {
                const double near = r / glm::length(v);
                return sized(v) && is_unit(n) && !(r < 1e-18) && (near < 0.95 || near > 1.0001);
            });
    };
    sphere("CS-H", &reference::gloam_contribution_sphere, 8e-7);
    sphere("CS-H-cosine", &reference::gloam_contribution_sphere_cosine, 5e-7);
    add(entries, "CS-H-above", &reference::gloam_above_horizon,
        {.domain = {proxy_offsets(), either(uniform(-4, 4), any_float()).and_near({0.0}).and_special()},
         .budget = {.backward_ulp = 6},
         .codomain = {0, 1}},
        [](glm::dvec3 v, double horizon) { return sized(v) && moderate(1e-9, 1e9, v, horizon); });
}

void append_discs(Entries& entries) {
    const Values area = either(log_uniform(1e-3, 10), log_uniform(1e-37, 1e38)).and_special();
    add(entries, "CS-S-share", &reference::gloam_disc_share,
        {.domain = {area, lengths()}, .budget = {.absolute = 4e-7}, .codomain = {0, 1}},
        [](double a, double d) { return !(a < 1e-30) && !(d < 1e-30); });
    const auto disc = [&](const char* id, auto reference, double absolute) {
        add(entries, id, reference,
            {.domain = {proxy_offsets(), normals(), normals(), area, uniform(0, 1).and_special()},
             .budget = {.absolute = absolute},
             .codomain = {0, 1}},
            [](glm::dvec3 v, glm::dvec3 n, glm::dvec3 e, double a, double) {
                return sized(v) && is_unit(n) && is_unit(e) && !(a < 1e-30);
            });
    };
    disc("CS-S", &reference::gloam_contribution_disc_proxy, 8e-7);
    disc("CS-S-cosine", &reference::gloam_contribution_disc_proxy_cosine, 6e-7);
}

void append_aksoy_phaneuf(Entries& entries) {
    add(entries, "CS-J", &reference::gloam_contribution_aksoy_phaneuf,
        {.domain = {proxy_offsets(), normals(), lengths(),
                    either(uniform(0, 0.1), constant(0.0F)).and_special()},
         .budget = {.absolute = 4e-7, .backward_ulp = 4},
         .codomain = {0, 1}},
        [](glm::dvec3 v, glm::dvec3 n, double r, double bias) {
            return sized(v) && is_unit(n) && !(r < 1e-18) &&
                   std::abs(glm::dot(v, n) - bias) > 1e-6 * glm::length(v);
        });
    const Values occlusion = uniform(0, 1).and_near({0.0, 1.0}).and_special();
    add(entries, "CS-J-radii", &reference::gloam_two_radii_sum,
        {.domain = {occlusion, occlusion}, .budget = {.ulp = 0.5}, .codomain = {0, 1}});
}

void append_occlusion_proxies(Entries& entries) {
    append_spheres(entries);
    append_discs(entries);
    append_aksoy_phaneuf(entries);
}

}  // namespace

void append_occlusion_scalable(Entries& entries) {
    append_parts(entries);
    append_contributions_of_sao(entries);
    append_combinations(entries);
    append_occlusion_layers(entries);
    append_occlusion_proxies(entries);
}

}  // namespace gloam::catalogue
