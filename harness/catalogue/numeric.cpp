// SPDX-License-Identifier: MIT
#include "reference/numeric.hpp"
#include "catalogue/inputs.hpp"
#include "catalogue/rooms.hpp"
#include "numeric/constants.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr double above_pi = 3.1415928;

constexpr const char* sincos_file = "gloam/numeric/sincos.glsl";
constexpr Codomain sincos_codomain{-1.000001, 1.000001};

void append_sincos_octant(Entries& entries) {
    entries.push_back(equation<glm::vec2(float, int)>(
        {.id = "SINCOS-octant",
         .function = "gloam_sincos_octant",
         .file = sincos_file,
         .title = "cosine and sine of an angle near a multiple of a quarter turn",
         .formula = "(cos a, sin a), a = r + q pi / 2",
         .source = "minimax polynomials"},
        &reference::gloam_sincos_octant,
        {.domain = {uniform(-0.7853982, 0.7853982), integers(-9, 9).and_near_integers({2147483647})},
         .budget = {.absolute = 1e-7},
         .codomain = sincos_codomain}));
}

void append_sincos(Entries& entries) {
    entries.push_back(equation<glm::vec2(float)>(
        {.id = "SINCOS-turns",
         .function = "gloam_sincos_turns",
         .file = sincos_file,
         .title = "cosine and sine of an angle in turns",
         .formula = "(cos 2 pi t, sin 2 pi t)",
         .source = "minimax polynomials after an exact reduction"},
        &reference::gloam_sincos_turns,
        {.domain = {either(uniform(-1, 1), either(signed_log_uniform(1e-9, 1e7), any_float()))
                        .and_near({0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0, -0.125, -0.25, -1.0})
                        .and_special()},
         .budget = {.absolute = 2e-7},
         .codomain = sincos_codomain}));
    entries.push_back(
        equation<glm::vec2(float)>({.id = "SINCOS",
                                    .function = "gloam_sincos",
                                    .file = sincos_file,
                                    .title = "cosine and sine of an angle in radians",
                                    .formula = "(cos a, sin a)",
                                    .source = "Cody and Waite 1980; minimax polynomials"},
                                   &reference::gloam_sincos,
                                   {.domain = {either(uniform(-7, 7), signed_log_uniform(1e-6, 65536))
                                                   .and_near({0.78539816, 1.57079633, 3.14159265, -3.14159265,
                                                              6.28318531, 65536.0, -65536.0})
                                                   .and_special()},
                                    .budget = {.absolute = 2e-7},
                                    .codomain = sincos_codomain}));
}

void append_turns(Entries& entries) {
    entries.push_back(
        equation<float(float)>({.id = "TURNS",
                                .function = "gloam_turns",
                                .file = sincos_file,
                                .title = "turns of an angle",
                                .formula = "a / (2 pi), 0 beyond 65536",
                                .source = "definition"},
                               &reference::gloam_turns,
                               {.domain = {uniform(-70000, 70000).and_near({65536.0}).and_special()},
                                .budget = {.ulp = 1.2},
                                .codomain = {-10430.4, 10430.4}}));
}

void append_square_root(Entries& entries) {
    entries.push_back(
        equation<float(float)>({.id = "SQRT",
                                .function = "gloam_sqrt",
                                .file = "gloam/numeric/square_root.glsl",
                                .title = "square root that is 0 at 0",
                                .formula = "x^(1/2), 0 for x <= 0",
                                .source = "x times its inverse square root"},
                               &reference::gloam_sqrt,
                               {.domain = {either(uniform(0, 4), any_float())
                                               .and_near({0x1p-126, 0x1p-125, 1.0, 0x1.fffffep127})
                                               .and_special()},
                                .budget = {.ulp = 2},
                                .codomain = {0, numeric::infinity}}));
}

// One function of the file, of one argument.
template <class Reference>
void append_inverse(Entries& entries, std::string id, std::string function, std::string title,
                    std::string formula, Reference reference, Question check) {
    entries.push_back(equation<float(float)>({.id = std::move(id),
                                              .function = std::move(function),
                                              .file = "gloam/numeric/inverse_trigonometry.glsl",
                                              .title = std::move(title),
                                              .formula = std::move(formula),
                                              .source = "minimax polynomial"},
                                             reference, std::move(check)));
}

void append_arc_sines(Entries& entries) {
    const Values cosine =
        either(uniform(-1.01, 1.01), either(signed_log_uniform(1e-30, 1), uniform(0.999, 1)))
            .and_near({1.0, -1.0, 0.5, -0.5})
            .and_special();
    append_inverse(entries, "ASIN-half", "gloam_asin_half", "arc sine near 0", "asin x, |x| <= 1/2",
                   &reference::gloam_asin_half,
                   {.domain = {either(uniform(-0.5, 0.5), signed_log_uniform(1e-30, 0.5))},
                    .budget = {.ulp = 1},
                    .codomain = {-0.6, 0.6}});
    append_inverse(entries, "UNIT-magnitude", "gloam_unit_magnitude", "magnitude of a sine or cosine",
                   "min(|x|, 1); 0 for NaN", &reference::gloam_unit_magnitude,
                   {.domain = {either(cosine, any_float())}, .codomain = {0, 1}});
    append_inverse(entries, "SMALL-ARC", "gloam_small_arc", "arc sine, or half the arc cosine, of m",
                   "asin m for m <= 1/2, else acos(m) / 2", &reference::gloam_small_arc,
                   {.domain = {either(uniform(0, 1), uniform(0.999, 1)).and_near({0.5}).and_value(1.0F)},
                    .budget = {.absolute = 1.5e-7},
                    .codomain = {0, 0.53}});
    append_inverse(
        entries, "ACOS", "gloam_acos", "arc cosine", "acos x", &reference::gloam_acos,
        {.domain = {either(cosine, any_float())}, .budget = {.absolute = 4e-7}, .codomain = {0, above_pi}});
    append_inverse(
        entries, "ASIN", "gloam_asin", "arc sine", "asin x", &reference::gloam_asin,
        {.domain = {either(cosine, any_float())}, .budget = {.absolute = 3e-7}, .codomain = {-1.571, 1.571}});
}

void append_unit_angle(Entries& entries) {
    const auto upper = [](numeric::Random& random) {
        const double angle = random.uniform(0.0, 3.14159265);
        const double small = std::exp(random.uniform(-20.0, 0.0));
        const double turn = random.uniform(0.0, 1.0) < 0.5 ? angle : std::min(angle, small);
        return glm::vec2(std::cos(turn), std::sin(turn));
    };
    entries.push_back(equation<float(glm::vec2)>({.id = "ANGLE-unit",
                                                  .function = "gloam_unit_angle",
                                                  .file = "gloam/numeric/unit_angle.glsl",
                                                  .title = "angle of a unit vector of the upper half plane",
                                                  .formula = "atan2(y, x), y >= 0, x^2 + y^2 = 1",
                                                  .source = "minimax polynomial"},
                                                 &reference::gloam_unit_angle,
                                                 {.domain = {made_by<glm::vec2>(upper).only_as_drawn()},
                                                  .budget = {.absolute = 4e-7},
                                                  .codomain = {0, above_pi}}));
}

void append_arc_tangents(Entries& entries) {
    constexpr const char* file = "gloam/numeric/inverse_trigonometry.glsl";
    const Values coordinate = either(uniform(-1, 1), any_float()).and_near({0x1p-126, 0x1p126}).and_special();
    const Values length = either(uniform(0, 1), log_uniform(1e-37, 3e38)).and_near({0x1p126}).and_special();
    const auto order = [](std::span<Word> words) {
        const auto a = from_word<float>(words[0]);
        const auto b = from_word<float>(words[1]);
        const bool usable = a >= 0.0F && b >= 0x1p-126F;
        words[0] = to_word(usable ? std::min(a, b) : 0.0F);
        words[1] = to_word(usable ? std::max(a, b) : 1.0F);
    };
    entries.push_back(
        equation<float(float, float)>({.id = "RATIO",
                                       .function = "gloam_length_ratio",
                                       .file = file,
                                       .title = "the smaller over the larger of two lengths",
                                       .formula = "a / b, 0 <= a <= b",
                                       .source = "definition"},
                                      &reference::gloam_length_ratio,
                                      {.domain = Domain{length, length}.tied(0, 1).adjusted(order),
                                       .budget = {.ulp = 0.5, .absolute = 0x1p-126},
                                       .codomain = {0, 1}}));
    entries.push_back(equation<float(float, float)>(
        {.id = "ATAN2",
         .function = "gloam_atan2",
         .file = file,
         .title = "direction of a point",
         .formula = "angle of (x, y), counter-clockwise from the x axis; 0 at the origin",
         .source = "minimax polynomial"},
        &reference::gloam_atan2,
        {.domain = Domain{coordinate, coordinate}.tied(0, 1).tied(0, 1, -1.0),
         .budget = {.absolute = 3e-7},
         .codomain = {-above_pi, above_pi}}));
    append_inverse(entries, "ATAN", "gloam_atan", "arc tangent", "atan x", &reference::gloam_atan,
                   {.domain = {either(uniform(-4, 4), any_float()).and_near({1.0, -1.0}).and_special()},
                    .budget = {.absolute = 2e-7},
                    .codomain = {-1.571, 1.571}});
}

}  // namespace

void append_numeric(Entries& entries) {
    append_sincos_octant(entries);
    append_sincos(entries);
    append_turns(entries);
    append_square_root(entries);
    append_arc_sines(entries);
    append_arc_tangents(entries);
    append_unit_angle(entries);
}

}  // namespace gloam::catalogue
