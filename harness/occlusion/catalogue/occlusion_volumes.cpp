// SPDX-License-Identifier: MIT
// The parts of the horizon sweep, and methods that pair opposite samples: volumetric obscurance and
// angle-based occlusion.
#include <cmath>

#include "catalogue/inputs.hpp"
#include "numeric/numbers.hpp"
#include "reference/numeric.hpp"
#include "reference/occlusion_points.hpp"
#include "reference/occlusion_slices.hpp"

namespace gloam::catalogue {
namespace {

using namespace subject;

using Side = reference::GloamSweepSide;

constexpr double half_pi = 1.5707964;

Values sides() {
    return made_by<Side>([](numeric::Random& random) {
               return Side{static_cast<float>(random.uniform(-1, 1)),
                           static_cast<float>(random.uniform(0, 1)),
                           static_cast<float>(random.uniform(0, 2)),
                           static_cast<float>(random.uniform(0, 1)),
                           static_cast<float>(random.uniform(0, 1)),
                           random.unit() < 0.5 ? 0.0F : static_cast<float>(random.uniform(0.01, 1)),
                           static_cast<float>(random.uniform(0, 1)),
                           glm::vec2(random.uniform(-1, 1), random.uniform(0, 1))};
           })
        .only_as_drawn();
}

void append_sides(Entries& entries) {
    add(entries, "FALLOFF-choice", &reference::gloam_falloff_at,
        {integers(0, 5), uniform(0, 1.2).and_near({1.0})}, {.absolute = 2e-7}, {0, 1});
    add(entries, "SWEEP-start", &reference::gloam_sweep_side, {uniform(-1, 1)}, {}, {-1, 1});
    const Values lengths = either(uniform(0, 2), log_uniform(1e-30, 1e18));
    add(entries, "SWEEP-distance", &reference::gloam_sweep_distance, {lengths, lengths},
        {.ulp = 1, .absolute = 1e-37}, {0, 1e18});
    add(entries, "SWEEP-slice", &reference::gloam_sweep_slice,
        {facing_slices(), uniform(1, 1).and_value(-1.0F).only_as_drawn()}, {}, {-half_pi, half_pi});
    add(entries, "SWEEP-behind", &reference::gloam_sweep_behind, {unit_vector(2), facing_slices()},
        {.absolute = 5e-7}, {-half_pi, half_pi}, [](const glm::dvec2& d, const reference::GloamSlice& slice) {
            return std::atan2(std::abs(d.y), d.x) <= static_cast<double>(slice.angle) + half_pi;
        });
    const Values offsets = vector_of_length(2, uniform(1e-3, 2)).only_as_drawn();
    add(entries, "SWEEP-uncover", &reference::gloam_sweep_uncover,
        {sides(), facing_slices(), offsets, booleans(), booleans(), integers(0, 3)},
        {.absolute = 8e-7, .backward_ulp = 4}, {-3, 3});
}

// Features: how much of them counts, where they end, and a tap that begins or continues one.
void append_features(Entries& entries) {
    const Values lengths = either(uniform(0, 2), log_uniform(1e-4, 1e4));
    const Values thicknesses = either(uniform(0, 3), log_uniform(1e-3, 1e18));
    add(entries, "SWEEP-share", &reference::gloam_sweep_share, {lengths, log_uniform(1e-4, 1e4), thicknesses},
        {.ulp = 3, .absolute = 1e-30}, {0, 1});
    const Values at = vector({uniform(-1, 1), uniform(0, 1)}).only_as_drawn();
    const Values moderate_thickness = uniform(0, 3).and_value(1e18F).only_as_drawn();
    add(entries, "SWEEP-end", &reference::gloam_sweep_end, {sides(), at, moderate_thickness},
        {.absolute = 1e-6, .backward_ulp = 4}, {-3, 3});
    const Values offsets = vector_of_length(2, uniform(1e-3, 2)).only_as_drawn();
    add(entries, "SWEEP-tap", &reference::gloam_sweep_tap,
        {sides(), facing_slices(), offsets, booleans(), booleans(), integers(0, 3), moderate_thickness},
        {.absolute = 2e-6, .backward_ulp = 4}, {-3, 3});
}

Values offsets() {
    return offsets_of(uniform(0.1, 1.5), log_uniform(1e-30, 1e30));
}

Values lengths() {
    return either(uniform(0.1, 2), log_uniform(1e-37, 1e38)).and_special();
}

double length_of(glm::dvec3 v) {
    return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

void append_lines(Entries& entries) {
    add(entries, "CS-P-acos-cubic", &reference::gloam_acos_cubic,
        {either(uniform(-1.1, 1.1), signed_log_uniform(1e-30, 1e30))
             .and_near({-1.0, 0.0, 1.0})
             .and_special()},
        {.absolute = 4e-7}, {0, 3.1415928});
    add(entries, "CS-I-chord", &reference::gloam_chord_half_height,
        {vector_of_length(2, uniform(0, 1.1)).and_special(), uniform(0.1, 2).and_special()},
        {.absolute = 8e-7}, {0, numeric::infinity}, [](glm::dvec2 xi, double radius) {
            const double squared = xi.x * xi.x + xi.y * xi.y;
            return !(squared > 0.99 && squared < 1.01) && moderate(1e-9, 2.1, radius);
        });
    const Values heights = either(uniform(-2, 2), signed_log_uniform(1e-37, 1e38)).and_special();
    const Domain line = Domain{heights, lengths()}.tied(0, 1).tied(0, 1, -1.0);
    add(entries, "CS-I", &reference::gloam_line_occlusion, line, {.absolute = 1.2e-7}, {0, 1});
    add(entries, "CS-I-ratio", &reference::gloam_line_ratio, line, {.ulp = 3, .absolute = 2e-7}, {},
        [](double height, double half_height) {
            return !std::isfinite(height) || !(std::abs(height) > 1e38 * half_height);
        });
    const Values fraction = uniform(-1, 2).and_near({0.35, 0.5, 1.0}).and_special();
    add(entries, "CS-I-pair", &reference::gloam_line_pair,
        {vector(2, fraction), uniform(0.2, 0.5).and_near({0.35}).and_special(),
         uniform(0.8, 1).and_near({1.0}).and_special()},
        {.ulp = 0.5, .absolute = 0x1p-126});
}

void append_areas_and_balls(Entries& entries) {
    add(entries, "CS-I-area", &reference::gloam_area_occlusion,
        Domain{either(uniform(-2, 2), signed_log_uniform(1e-37, 1e38)).and_special(),
               either(uniform(0, 2), lengths()).and_value(0.0F), lengths()}
            .tied(0, 2)
            .tied(0, 1)
            .tied(1, 2),
        {.absolute = 2e-7}, {0, 1});
    const Values solid = uniform(0, 1).and_near({0.0, 0.5, 1.0}).and_special();
    add(entries, "CS-I-two-balls", &reference::gloam_two_balls, {solid, solid}, {.absolute = 1.2e-7}, {0, 1});
    // Not near the outline of the sphere.
    const auto inside = [](glm::dvec3 v, glm::dvec3 n, double radius) {
        const glm::dvec2 xi(v.x / (0.5 * radius) - n.x, v.y / (0.5 * radius) - n.y);
        const double squared = xi.x * xi.x + xi.y * xi.y;
        return moderate(0.1, 2.1, radius) && length_of(v) < 2 && length_of(n) < 1.1 &&
               (squared < 0.9 || squared > 1.1);
    };
    const Domain domain{either(vector_of_length(3, uniform(0, 0.6)), offsets()), normals(),
                        either(uniform(0.5, 2), lengths())};
    add(entries, "CS-I-tangent-chord", &reference::gloam_tangent_sphere_half_height, domain,
        {.absolute = 4e-7}, {0, 1e38}, inside);
    add(entries, "CS-I-tangent", &reference::gloam_tangent_sphere_occlusion, domain, {.absolute = 5e-7},
        {0, 1}, inside);
}

// Whether an offset's direction is not close to -n, where its part in the tangent plane has no direction.
bool clear_of_nadir(glm::dvec3 v, glm::dvec3 n) {
    const double length = length_of(v);
    if (length == 0.0) return true;
    const double above = (v.x * n.x + v.y * n.y + v.z * n.z) / length;
    return above > -0.95 && moderate(1e-9, 2, n);
}

}  // namespace

void append_occlusion_volumes(Entries& entries) {
    append_sides(entries);
    append_features(entries);
    append_lines(entries);
    append_areas_and_balls(entries);
    add(entries, "CS-P-lifted", &reference::gloam_lifted_cosine, {offsets(), normals(), unit_vector(3)},
        {.absolute = 5e-7}, {-1, 1},
        [](glm::dvec3 v, glm::dvec3 n, glm::dvec3) { return clear_of_nadir(v, n); });
    add(entries, "CS-P-near", &reference::gloam_sample_near, {offsets(), uniform(0, 2).and_special()});
    add(entries, "CS-P-pair", &reference::gloam_angle_pair,
        {offsets(), offsets(), normals(), unit_vector(3), uniform(0, 2).and_special()}, {.absolute = 5e-7},
        {-1, 1}, [](glm::dvec3 a, glm::dvec3 b, glm::dvec3 n, glm::dvec3, double) {
            return clear_of_nadir(a, n) && clear_of_nadir(b, n);
        });
    add(entries, "CS-P-unreal", &reference::gloam_contribution_unreal,
        {either(vector_of_length(3, uniform(0.1, 1.5)), vector_of_length(3, log_uniform(1e-15, 1e15))),
         unit_vector(3), either(constant(0.0F), uniform(0, 0.1)), uniform(0.1, 1)},
        {.absolute = 1e-6, .backward_ulp = 4}, {0, 1},
        [](glm::dvec3 v, glm::dvec3, double, double) { return length_of(v) >= 0.1 && length_of(v) < 1e9; });
    add(entries, "CS-P-unreal-side", &reference::gloam_unreal_side, {shares()}, {.ulp = 2}, {0, 1});
    add(entries, "CS-P-unreal-visibility", &reference::gloam_unreal_visibility,
        {uniform(0, 1).and_special(), uniform(0.5, 4).and_near({1.0}).and_special(),
         uniform(0, 1).and_near({1.0}).and_special()},
        {.absolute = 1e-6, .backward_ulp = 2}, {0, 1}, [](double ao, double power, double intensity) {
            return moderate(1e-9, 2, ao, intensity) && power >= 0.4 && power <= 4;
        });
}

}  // namespace gloam::catalogue
