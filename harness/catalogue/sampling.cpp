// SPDX-License-Identifier: MIT
#include "reference/sampling.hpp"
#include "catalogue/inputs.hpp"
#include "catalogue/relatives_parts.hpp"
#include "catalogue/rooms.hpp"
#include "catalogue/sampling_parts.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

// Random numbers for a map: [0, 1], and all special floats.
Values zeta(int components) {
    return vector(components, uniform(0, 1).and_near({0.5, 1.0}).and_value(1e-30F)).and_special();
}

Values sample_index() {
    return log_integers(4294967295).and_near_integers({16777216, 4294967295});
}

void append_halton(Entries& entries) {
    entries.push_back(equation<glm::vec2(unsigned)>(
        {.id = "HALTON-2D",
         .function = "gloam_halton_2d",
         .file = "gloam/sampling/halton.glsl",
         .title = "point of the Halton sequence, bases 2 and 3",
         .formula = "(Phi_2(i), Phi_3(i))",
         .source = "Halton 1960; kernels of TSSAO-13"},
        &reference::gloam_halton_2d,
        {.domain = {sample_index()}, .budget = {.ulp = 2}, .codomain = {0, 0.99999995}}));
    entries.push_back(equation<glm::vec3(unsigned)>(
        {.id = "HALTON-3D",
         .function = "gloam_halton_3d",
         .file = "gloam/sampling/halton.glsl",
         .title = "point of the Halton sequence, bases 2, 3 and 5",
         .formula = "(Phi_2(i), Phi_3(i), Phi_5(i))",
         .source = "Halton 1960; kernels of TSSAO-14"},
        &reference::gloam_halton_3d,
        {.domain = {sample_index()}, .budget = {.ulp = 2}, .codomain = {0, 0.99999995}}));
}

void append_radii(Entries& entries) {
    const auto radius = [&entries](std::string id, std::string function, std::string formula, auto reference,
                                   Budget budget) {
        entries.push_back(equation<float(float)>(
            {.id = std::move(id),
             .function = std::move(function),
             .file = "gloam/sampling/radius_law.glsl",
             .title = "sample radius for a falloff",
             .formula = std::move(formula),
             .source = "derived: falloff = 1 - distribution of the radius"},
            reference,
            {.domain = {either(uniform(0, 1).and_near({0.5, 1.0}), log_uniform(1e-38, 1)).and_special()},
             .budget = budget,
             .codomain = {0, 1}}));
    };
    radius("RADIUS-linear", "gloam_radius_linear", "r = zeta (falloff 1 - x)",
           &reference::gloam_radius_linear, {});
    radius("RADIUS-quadratic", "gloam_radius_quadratic", "r = sqrt(zeta) (falloff 1 - x^2)",
           &reference::gloam_radius_quadratic, {.ulp = 2});
    radius("RADIUS-cubic", "gloam_radius_cubic", "r = zeta^(1/3) (falloff 1 - x^3)",
           &reference::gloam_radius_cubic, {.ulp = 1.5});
}

void append_disc_maps(Entries& entries) {
    entries.push_back(equation<float(float)>(
        {.id = "UNIT",
         .function = "gloam_unit_interval",
         .file = "gloam/sampling/unit_interval.glsl",
         .title = "number brought into [0, 1]",
         .formula = "x inside [0, 1], else the nearer end; 0 for NaN",
         .source = "convention"},
        &reference::gloam_unit_interval,
        {.domain = {either(zeta(1), either(any_float(), uniform(-2, 2)))}, .codomain = {0, 1}}));
    entries.push_back(equation<glm::vec2(float)>(
        {.id = "CIRCLE",
         .function = "gloam_circle_point",
         .file = "gloam/sampling/circle.glsl",
         .title = "point of the unit circle at a part of a turn",
         .formula = "(cos 2 pi t, sin 2 pi t)",
         .source = "definition"},
        &reference::gloam_circle_point,
        {.domain = {zeta(1)}, .budget = {.absolute = 2e-7}, .codomain = {-1.000001, 1.000001}}));
    entries.push_back(equation<glm::vec2(glm::vec2)>(
        {.id = "TSSAO-13",
         .function = "gloam_disc_sample",
         .file = "gloam/sampling/disc.glsl",
         .title = "uniform point of the disc",
         .formula = "a = 2 pi zeta_x, r = sqrt(zeta_y); s = (r cos a, r sin a)",
         .source = "TSSAO (Mattausch et al.), eq 13; Fox and Compton's kernel"},
        &reference::gloam_disc_sample,
        {.domain = {zeta(2)}, .budget = {.absolute = 3e-7}, .codomain = {-1.000001, 1.000001}}));
}

}  // namespace

void append_sequences(Entries& entries) {
    entries.push_back(equation<float(unsigned)>(
        {.id = "HALTON-base2",
         .function = "gloam_radical_inverse_base2",
         .file = "gloam/sampling/radical_inverse.glsl",
         .title = "radical inverse in base 2",
         .formula = "Phi_2(i) = sum of a_m 2^(-m-1), i = sum of a_m 2^m",
         .source = "van der Corput 1935; Halton 1960"},
        &reference::gloam_radical_inverse_base2, {.domain = {sample_index()}, .codomain = {0, 0.99999995}}));
    entries.push_back(equation<float(unsigned, unsigned)>(
        {.id = "HALTON",
         .function = "gloam_radical_inverse",
         .file = "gloam/sampling/radical_inverse.glsl",
         .title = "radical inverse in any base",
         .formula = "Phi_b(i) = sum of a_m b^(-m-1), i = sum of a_m b^m",
         .source = "Halton 1960"},
        &reference::gloam_radical_inverse,
        {.domain = {sample_index(),
                    log_integers(4000).and_near_integers({2, 3, 5, 256, 1625, 65536, 16777216, 4294967295})},
         .budget = {.ulp = 2},
         .codomain = {0, 0.99999995}}));
    append_halton(entries);
}

void append_sample_maps(Entries& entries) {
    append_disc_maps(entries);
    entries.push_back(equation<glm::vec3(glm::vec3)>(
        {.id = "TSSAO-14",
         .function = "gloam_hemisphere_cosine",
         .file = "gloam/sampling/hemisphere.glsl",
         .title = "point of the half ball: cosine-weighted direction, uniform radius",
         .formula = "a = 2 pi zeta_x, r = zeta_y; s = r (cos a sqrt(1 - zeta_z), sin a sqrt(1 - zeta_z), "
                    "sqrt(zeta_z))",
         .source = "TSSAO (Mattausch et al.), eq 14 corrected; Ritschel's kernel"},
        &reference::gloam_hemisphere_cosine,
        {.domain = {zeta(3)}, .budget = {.absolute = 3e-7}, .codomain = {-1.000001, 1.000001}}));
    entries.push_back(equation<glm::vec3(glm::vec3)>(
        {.id = "TSSAO-14-uniform",
         .function = "gloam_hemisphere_uniform",
         .file = "gloam/sampling/hemisphere.glsl",
         .title = "point of the half ball: uniform direction, uniform radius",
         .formula = "a = 2 pi zeta_x, r = zeta_y; s = r (cos a sqrt(1 - zeta_z^2), sin a sqrt(1 - zeta_z^2), "
                    "zeta_z)",
         .source = "TSSAO (Mattausch et al.), variant of eq 14"},
        &reference::gloam_hemisphere_uniform,
        {.domain = {zeta(3)}, .budget = {.absolute = 3e-7}, .codomain = {-1.000001, 1.000001}}));
    append_radii(entries);
}

void append_sampling(Entries& entries) {
    append_sequences(entries);
    append_sample_maps(entries);
    append_sample_rotations(entries);
    append_sample_patterns(entries);
    append_sampling_levels(entries);
    append_sampling_marches(entries);
}

}  // namespace gloam::catalogue
