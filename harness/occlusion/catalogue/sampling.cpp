// SPDX-License-Identifier: MIT
// Sequences, the points made of them, rotations, the depth chain and how many samples are taken.
#include <algorithm>
#include <cmath>

#include "catalogue/inputs.hpp"
#include "numeric/numbers.hpp"
#include "reference/sampling.hpp"

namespace gloam::catalogue {
namespace {

using namespace subject;

// Random numbers for a map: [0, 1], and all special floats.
Values zeta(int components) {
    return vector(components, uniform(0, 1).and_near({0.5, 1.0}).and_value(1e-30F)).and_special();
}

Values sample_index() {
    return log_integers(4294967295).and_near_integers({16777216, 4294967295});
}

void append_sequences_and_maps(Entries& entries) {
    add(entries, "HALTON-base2", &reference::gloam_radical_inverse_base2, {sample_index()}, {},
        {0, 0.99999995});
    add(entries, "HALTON", &reference::gloam_radical_inverse,
        {sample_index(),
         log_integers(4000).and_near_integers({2, 3, 5, 256, 1625, 65536, 16777216, 4294967295})},
        {.ulp = 3}, {0, 0.99999995});
    add(entries, "HALTON-2D", &reference::gloam_halton_2d, {sample_index()}, {.ulp = 3}, {0, 0.99999995});
    add(entries, "HALTON-3D", &reference::gloam_halton_3d, {sample_index()}, {.ulp = 3}, {0, 0.99999995});
    add(entries, "UNIT", &reference::gloam_unit_interval,
        {either(zeta(1), either(any_float(), uniform(-2, 2)))}, {}, {0, 1});
    add(entries, "CIRCLE", &reference::gloam_circle_point, {zeta(1)}, {.absolute = 2e-7},
        {-1.000001, 1.000001});
    add(entries, "TSSAO-13", &reference::gloam_disc_sample, {zeta(2)}, {.absolute = 3e-7},
        {-1.000001, 1.000001});
    add(entries, "TSSAO-14", &reference::gloam_hemisphere_cosine, {zeta(3)}, {.absolute = 3e-7},
        {-1.000001, 1.000001});
    add(entries, "TSSAO-14-uniform", &reference::gloam_hemisphere_uniform, {zeta(3)}, {.absolute = 3e-7},
        {-1.000001, 1.000001});
}

Values kernel_points(int components) {
    return either(vector_of_length(components, uniform(0, 1)), unit_vector(components));
}

Values angles() {
    return either(uniform(-7, 7), signed_log_uniform(1e-6, 65536))
        .and_near({3.14159265, -3.14159265, 6.28318531, 65536.0, -65536.0})
        .and_special();
}

// Whether the largest component is in [1e-30, 1e19], or the vector is zero: products of shorter vectors may
// be flushed, and those of longer ones overflow.
template <class V>
bool turnable(const V& v) {
    float largest = 0.0F;
    for (glm::length_t i = 0; i < V::length(); ++i) {
        if (!(std::abs(v[i]) <= 1e19F)) return false;
        largest = std::max(largest, std::abs(v[i]));
    }
    return !(largest > 0.0F && largest < 1e-30F);
}

// Unit vectors, some near an axis, where a component or its square cancels.
Values near_an_axis(Values normals) {
    return std::move(normals)
        .and_value(glm::vec3(1.0F, 0.0F, -1e-30F), true)
        .and_value(glm::vec3(0.6F, 0.8F, 1e-8F), true)
        .and_value(glm::vec3(0.6F, 0.8F, -1e-8F), true)
        .and_value(glm::vec3(1e-7F, 2e-7F, -1.0F))
        .and_value(glm::vec3(-1e-4F, 1e-4F, -1.0F));
}

// (cos, sin) of angles.
Values turns() {
    return made_by<glm::vec2>([](numeric::Random& random) {
               return glm::vec2(reference::gloam_sincos(random.uniform(-4, 4)));
           })
        .and_value(glm::vec2(1, 0), true);
}

void append_sample_rotations(Entries& entries) {
    add(entries, "FRAME", &reference::gloam_tangent_frame, {near_an_axis(unit_vector(3)).only_as_drawn()},
        {.absolute = 3e-7}, {-1.000001, 1.000001});
    add(entries, "TSSAO-ROT-turn-disc", &reference::gloam_turn_disc,
        {kernel_points(2).only_as_drawn(), turns().only_as_drawn()}, {.ulp = 3, .of_largest_component = true},
        {-2e19, 2e19}, [](const auto& s, const auto&) { return turnable(s); });
    add(entries, "TSSAO-ROT-turn-hemisphere", &reference::gloam_turn_hemisphere,
        {kernel_points(3).only_as_drawn(), turns().only_as_drawn()}, {.ulp = 3, .of_largest_component = true},
        {-2e19, 2e19}, [](const auto& s, const auto&) { return turnable(s); });
    add(entries, "TSSAO-ROT-disc", &reference::gloam_rotate_disc,
        {kernel_points(2).only_as_drawn(), angles()}, {.ulp = 4, .of_largest_component = true}, {-2e19, 2e19},
        [](const auto& s, float) { return turnable(s); });
    add(entries, "TSSAO-ROT-hemisphere", &reference::gloam_rotate_hemisphere,
        {kernel_points(3).only_as_drawn(), angles()}, {.ulp = 4, .of_largest_component = true}, {-2e19, 2e19},
        [](const auto& s, float) { return turnable(s); });
    add(entries, "HASH-turn", &reference::gloam_hash_turn,
        {either(log_integers(4294967295), integers(0, 4294967295))
             .and_near_integers({0, 65536, 4294967295})});
    const Values coordinate = either(integers(0, 8191), integers(-2147483648L, 2147483647L));
    add(entries, "HASH-ROT", &reference::gloam_hash_rotation,
        {vector(2, coordinate.and_near_integers({0, 65536, 2147483647}))}, {.ulp = 3, .absolute = 4e-9},
        {0, 6.2831853});
    add(entries, "LATTICE-ROT", &reference::gloam_lattice_rotation,
        {vector(2, coordinate.and_near_integers({0, 65536, 2147483647}))}, {.ulp = 3, .absolute = 4e-9},
        {0, 6.2831855});
    const Values texel = vector(3, uniform(0, 1).and_near({0.5}))
                             .and_value(glm::vec3(0.5F))
                             .and_value(glm::vec3(0.5F, 0.5F, 0.50000006F), true)
                             .and_special();
    add(entries, "REFLECT", &reference::gloam_reflect_sample, {kernel_points(3).and_special(), texel},
        {.ulp = 16, .of_largest_component = true}, {-4e19, 4e19},
        [](const glm::vec3& s, const glm::vec3&) { return turnable(s); });
    const Values any = either(unit_vector(3), vector_of_length(3, log_uniform(1e-37, 1e38)));
    add(entries, "FLIP", &reference::gloam_hemisphere_flip,
        {kernel_points(3).and_special(), near_an_axis(any).and_special()}, {.backward_ulp = 2}, {-1e19, 1e19},
        [](glm::dvec3 s, glm::dvec3 normal) { return moderate(1e-15, 1e15, s, normal); });
}

// Sets one input in eight to the distance itself, where the result changes.
void place_at_distance(std::span<Word> words) {
    if (words[0] % 8U != 2U) return;  // no special float ends in these bits
    const glm::dvec2 a(from_word<double>(words[0]), from_word<double>(words[1]));
    const glm::dvec2 b(from_word<double>(words[2]), from_word<double>(words[3]));
    words[4] = to_word(glm::distance(a, b));
}

void append_sample_patterns(Entries& entries) {
    const Values count = log_integers(32768).and_near_integers({0, 32768, 2147483647});
    const Values turns =
        either(integers(-64, 64), integers(-2147483648L, 2147483647L)).and_near_integers({2147483647});
    add(entries, "SPIRAL-point", &reference::gloam_spiral_point, {count, count, turns}, {.absolute = 5e-7},
        {-1.000001, 1.000001});
    const Values point = vector_of_length(2, uniform(0, 1)).and_special();
    const auto representable = [](glm::dvec2 a, glm::dvec2 b, double distance) {
        const double apart = glm::distance(a, b);
        // Squares of values outside this range overflow or underflow.
        return !(distance > 0 && distance < 1e-18) && !(apart > 0 && apart < 1e-18) && !(apart > 1e18) &&
               !(distance > 1e18);
    };
    add(entries, "POISSON", &reference::gloam_poisson_accepts,
        Domain{point, point, uniform(0, 2).and_special()}.adjusted(place_at_distance), {.backward_ulp = 3},
        {}, representable);
    add(entries, "POISSON-lift", &reference::gloam_hemisphere_lift,
        {either(vector_of_length(
                    2, either(uniform(0, 1), either(uniform(0.9999, 1.0001), uniform(0.9999995, 1.0000005)))),
                vector_of_length(2, log_uniform(1e-37, 1e38)))
             .and_special()},
        {.absolute = 6e-6}, {-1.000001, 1.000001});
}

Values sizes() {
    return either(vector(2, integers(1, 40)), vector(2, integers(-2, 16384)));
}

Values levels() {
    return either(integers(0, 5), integers(-2, 40));
}

Values pixels() {
    return either(vector(2, integers(0, 40)), vector(2, integers(-16, 16384)));
}

// Near an integer, rounding decides on which side of it the quotient falls.
bool off_a_whole_number(double depth, double z_far, int base, int) {
    const double start = std::clamp(base, 0, 4096);
    const double quotient = start / (1 + start * std::min(depth / z_far, 1.0));
    return !(std::abs(quotient - std::round(quotient)) <= 1e-6 * quotient) || depth == 0 || base <= 0;
}

}  // namespace

void append_sampling(Entries& entries) {
    append_sequences_and_maps(entries);
    append_sample_rotations(entries);
    append_sample_patterns(entries);
    const Values distance = either(log_uniform(1, 2048), any_float())
                                .and_near({8.0, 16.0, 32.0, 64.0, 128.0, 256.0})
                                .and_special();
    add(entries, "CS-Q-level", &reference::gloam_depth_mip_level,
        Domain{distance, either(constant(16.0F), log_uniform(1, 64)).and_special(), levels()}.tied(0, 1).tied(
            0, 1, 4.0));
    add(entries, "CS-Q-size", &reference::gloam_depth_mip_size, {sizes(), levels()});
    add(entries, "CS-Q-pixel", &reference::gloam_depth_mip_pixel, {pixels(), sizes(), levels()});
    add(entries, "CS-Q-grid", &reference::gloam_rotated_grid, {pixels(), sizes()});
    add(entries, "CS-Q-source", &reference::gloam_depth_mip_source,
        {vector(2, integers(0, 600)), sizes(), levels()});
    add(entries, "CS-N", &reference::gloam_count_by_distance,
        Domain{either(uniform(0, 120), log_uniform(1e-3, 1e6)).and_special(),
               either(log_uniform(10, 1000), log_uniform(1e-37, 1e38)).and_special(),
               either(integers(0, 64), integers(-2, 10000)), integers(0, 16)}
            .tied(0, 1),
        {}, {0, 4096}, off_a_whole_number);
    add(entries, "CS-C2", &reference::gloam_eye_march,
        {vector(3, uniform(-8, 8)), unit_vector(3), uniform(0, 2), integers(0, 15), integers(1, 16),
         uniform(0, 1).and_near({1.0})},
        {.absolute = 1e-6}, {-50, 50},
        [](glm::dvec3, glm::dvec3, double, unsigned index, unsigned count, double) { return index < count; });
}

}  // namespace gloam::catalogue
