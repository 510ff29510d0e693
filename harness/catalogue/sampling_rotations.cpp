// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/sampling_parts.hpp"
#include "reference/sampling.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

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
Values unit_normals() {
    return near_an_axis(unit_vector(3)).only_as_drawn();
}
Values normals() {
    return near_an_axis(either(unit_vector(3), vector_of_length(3, log_uniform(1e-37, 1e38)))).and_special();
}

// (cos, sin) of angles.
Values turns() {
    return made_by<glm::vec2>([](numeric::Random& random) {
               return glm::vec2(reference::gloam_sincos(random.uniform(-4, 4)));
           })
        .and_value(glm::vec2(1, 0), true);
}

void append_turn(Entries& entries) {
    entries.push_back(equation<glm::vec2(glm::vec2, glm::vec2)>(
        {.id = "TSSAO-ROT-turn-disc",
         .function = "gloam_turn_disc",
         .file = "gloam/sampling/rotation.glsl",
         .title = "disc sample turned by the cosine and sine of an angle",
         .formula = "(c x - s y, s x + c y)",
         .source = "TSSAO (Mattausch et al.), random rotation"},
        &reference::gloam_turn_disc,
        {.domain = {kernel_points(2).only_as_drawn(), turns().only_as_drawn()},
         .budget = {.ulp = 3, .of_largest_component = true},
         .codomain = {-2e19, 2e19},
         .promised = make_predicate<glm::vec2(glm::vec2, glm::vec2)>(
             [](const auto& s, const auto&) { return turnable(s); })}));
    entries.push_back(equation<glm::vec3(glm::vec3, glm::vec2)>(
        {.id = "TSSAO-ROT-turn-hemisphere",
         .function = "gloam_turn_hemisphere",
         .file = "gloam/sampling/rotation.glsl",
         .title = "hemisphere sample turned by the cosine and sine of an angle",
         .formula = "(c x - s y, s x + c y, z)",
         .source = "TSSAO (Mattausch et al.), random rotation"},
        &reference::gloam_turn_hemisphere,
        {.domain = {kernel_points(3).only_as_drawn(), turns().only_as_drawn()},
         .budget = {.ulp = 3, .of_largest_component = true},
         .codomain = {-2e19, 2e19},
         .promised = make_predicate<glm::vec3(glm::vec3, glm::vec2)>(
             [](const auto& s, const auto&) { return turnable(s); })}));
}

void append_rotation(Entries& entries) {
    entries.push_back(equation<glm::vec2(glm::vec2, float)>(
        {.id = "TSSAO-ROT-disc",
         .function = "gloam_rotate_disc",
         .file = "gloam/sampling/rotation.glsl",
         .title = "disc sample rotated about the centre",
         .formula = "(c x - s y, s x + c y)",
         .source = "TSSAO (Mattausch et al.), random rotation"},
        &reference::gloam_rotate_disc,
        {.domain = {kernel_points(2).only_as_drawn(), angles()},
         .budget = {.ulp = 4, .of_largest_component = true},
         .codomain = {-2e19, 2e19},
         .promised =
             make_predicate<glm::vec2(glm::vec2, float)>([](const auto& s, float) { return turnable(s); })}));
    entries.push_back(equation<glm::vec3(glm::vec3, float)>(
        {.id = "TSSAO-ROT-hemisphere",
         .function = "gloam_rotate_hemisphere",
         .file = "gloam/sampling/rotation.glsl",
         .title = "hemisphere sample rotated about the normal",
         .formula = "(c x - s y, s x + c y, z)",
         .source = "TSSAO (Mattausch et al.), random rotation"},
        &reference::gloam_rotate_hemisphere,
        {.domain = {kernel_points(3).only_as_drawn(), angles()},
         .budget = {.ulp = 4, .of_largest_component = true},
         .codomain = {-2e19, 2e19},
         .promised =
             make_predicate<glm::vec3(glm::vec3, float)>([](const auto& s, float) { return turnable(s); })}));
}

void append_hash(Entries& entries) {
    entries.push_back(
        equation<unsigned(unsigned)>({.id = "HASH-turn",
                                      .function = "gloam_hash_turn",
                                      .file = "gloam/sampling/hash_rotation.glsl",
                                      .title = "10 h radians as a part of a turn",
                                      .formula = "floor(2^32 frac(10 h / (2 pi)))",
                                      .source = "fixed-point arithmetic of 64 bits"},
                                     &reference::gloam_hash_turn,
                                     {.domain = {either(log_integers(4294967295), integers(0, 4294967295))
                                                     .and_near_integers({0, 65536, 4294967295})}}));
    const Values coordinate = either(integers(0, 8191), integers(-2147483648L, 2147483647L));
    entries.push_back(equation<float(glm::ivec2)>(
        {.id = "HASH-ROT",
         .function = "gloam_hash_rotation",
         .file = "gloam/sampling/hash_rotation.glsl",
         .title = "rotation angle of a pixel by a hash",
         .formula = "10 ((3 x) XOR (y + x y)) modulo 2 pi",
         .source = "McGuire et al., Alchemy and Scalable Ambient Obscurance shaders"},
        &reference::gloam_hash_rotation,
        {.domain = {vector(2, coordinate.and_near_integers({0, 65536, 2147483647}))},
         .budget = {.ulp = 3, .absolute = 4e-9},
         .codomain = {0, 6.2831853}}));
}

void append_reflections(Entries& entries) {
    const Values texel = vector(3, uniform(0, 1).and_near({0.5}))
                             .and_value(glm::vec3(0.5F))
                             .and_value(glm::vec3(0.5F, 0.5F, 0.50000006F), true)
                             .and_special();
    entries.push_back(equation<glm::vec3(glm::vec3, glm::vec3)>(
        {.id = "REFLECT",
         .function = "gloam_reflect_sample",
         .file = "gloam/sampling/reflect.glsl",
         .title = "sample reflected at a random plane",
         .formula = "s - 2 (s . n) n, n = normalize(2 t - 1)",
         .source = "Mittring 2007"},
        &reference::gloam_reflect_sample,
        {.domain = {kernel_points(3).and_special(), texel},
         .budget = {.ulp = 16, .of_largest_component = true},
         .codomain = {-4e19, 4e19},
         .promised = make_predicate<glm::vec3(glm::vec3, glm::vec3)>(
             [](const glm::vec3& s, const glm::vec3&) { return turnable(s); })}));
    entries.push_back(equation<glm::vec3(glm::vec3, glm::vec3)>(
        {.id = "FLIP",
         .function = "gloam_hemisphere_flip",
         .file = "gloam/sampling/hemisphere_flip.glsl",
         .title = "sample brought into the hemisphere of a normal",
         .formula = "s if s . n > 0, else -s",
         .source = "Filion and McNaughton 2008"},
        &reference::gloam_hemisphere_flip,
        {.domain = {kernel_points(3).and_special(), normals()},
         .budget = {.backward_ulp = 2},
         .codomain = {-1e19, 1e19},
         .promised = make_predicate<glm::vec3(glm::vec3, glm::vec3)>(
             [](glm::dvec3 s, glm::dvec3 normal) { return moderate(1e-15, 1e15, s, normal); })}));
}

}  // namespace

void append_sample_rotations(Entries& entries) {
    entries.push_back(equation<glm::mat3(glm::vec3)>(
        {.id = "FRAME",
         .function = "gloam_tangent_frame",
         .file = "gloam/sampling/tangent_frame.glsl",
         .title = "orthonormal frame around a normal",
         .formula = "columns t, b, n: z turned onto n the shortest way",
         .source = "Duff et al. 2017"},
        &reference::gloam_tangent_frame,
        {.domain = {unit_normals()}, .budget = {.absolute = 3e-7}, .codomain = {-1.000001, 1.000001}}));
    append_turn(entries);
    append_rotation(entries);
    append_hash(entries);
    append_reflections(entries);
}

}  // namespace gloam::catalogue
