// SPDX-License-Identifier: MIT
// Angles, roots and ratios.
#include "reference/numeric.hpp"
#include "catalogue/inputs.hpp"
#include "numeric/numbers.hpp"

namespace gloam::catalogue {
namespace {

using namespace judge;
using namespace subject;

constexpr double above_pi = 3.1415928;

constexpr Codomain sincos_codomain{-1.000001, 1.000001};

void append_sines(Entries& entries) {
    add(entries, "SINCOS-octant", &reference::gloam_sincos_octant,
        {uniform(-0.7853982, 0.7853982), integers(-9, 9).and_near_integers({2147483647})}, {.absolute = 1e-7},
        sincos_codomain);
    add(entries, "SINCOS-turns", &reference::gloam_sincos_turns,
        {either(uniform(-1, 1), either(signed_log_uniform(1e-9, 1e7), any_float()))
             .and_near({0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0, -0.125, -0.25, -1.0})
             .and_special()},
        {.absolute = 2e-7}, sincos_codomain);
    add(entries, "SINCOS", &reference::gloam_sincos,
        {either(uniform(-7, 7), signed_log_uniform(1e-6, 65536))
             .and_near({0.78539816, 1.57079633, 3.14159265, -3.14159265, 6.28318531, 65536.0, -65536.0})
             .and_special()},
        {.absolute = 2e-7}, sincos_codomain);
    add(entries, "TURNS", &reference::gloam_turns, {uniform(-70000, 70000).and_near({65536.0}).and_special()},
        {.ulp = 1.2}, {-10430.4, 10430.4});
    add(entries, "SQRT", &reference::gloam_sqrt,
        {either(uniform(0, 4), any_float())
             .and_near({0x1p-126, 0x1p-125, 1.0, 0x1.fffffep127})
             .and_special()},
        {.ulp = 2.5}, {0, numeric::infinity});
    const Values cosine =
        either(uniform(-1.01, 1.01), either(signed_log_uniform(1e-30, 1), uniform(0.999, 1)))
            .and_near({1.0, -1.0, 0.5, -0.5})
            .and_special();
    add(entries, "ASIN-half", &reference::gloam_asin_half,
        {either(uniform(-0.5, 0.5), signed_log_uniform(1e-30, 0.5))}, {.ulp = 1}, {-0.6, 0.6});
    add(entries, "UNIT-magnitude", &reference::gloam_unit_magnitude, {either(cosine, any_float())}, {},
        {0, 1});
    add(entries, "SMALL-ARC", &reference::gloam_small_arc,
        {either(uniform(0, 1), uniform(0.999, 1)).and_near({0.5}).and_value(1.0F)}, {.absolute = 1.5e-7},
        {0, 0.53});
    add(entries, "ACOS", &reference::gloam_acos, {either(cosine, any_float())}, {.absolute = 4e-7},
        {0, above_pi});
}

}  // namespace

void append_numeric(Entries& entries) {
    append_sines(entries);
    const Values coordinate = either(uniform(-1, 1), any_float()).and_near({0x1p-126, 0x1p126}).and_special();
    const Values length = either(uniform(0, 1), log_uniform(1e-37, 3e38)).and_near({0x1p126}).and_special();
    const auto order = [](std::span<Word> words) {
        const auto a = from_word<float>(words[0]);
        const auto b = from_word<float>(words[1]);
        const bool usable = a >= 0.0F && b >= 0x1p-126F;
        words[0] = to_word(usable ? std::min(a, b) : 0.0F);
        words[1] = to_word(usable ? std::max(a, b) : 1.0F);
    };
    add(entries, "RATIO", &reference::gloam_length_ratio, Domain{length, length}.tied(0, 1).adjusted(order),
        {.ulp = 2.5, .absolute = 0x1p-126}, {0, 1});
    add(entries, "ATAN2", &reference::gloam_atan2, Domain{coordinate, coordinate}.tied(0, 1).tied(0, 1, -1.0),
        {.absolute = 3e-7}, {-above_pi, above_pi});
    add(entries, "ATAN", &reference::gloam_atan,
        {either(uniform(-4, 4), any_float()).and_near({1.0, -1.0}).and_special()}, {.absolute = 2e-7},
        {-1.571, 1.571});
    const auto upper = [](numeric::Random& random) {
        const double angle = random.uniform(0.0, 3.14159265);
        const double small = std::exp(random.uniform(-20.0, 0.0));
        const double turn = random.uniform(0.0, 1.0) < 0.5 ? angle : std::min(angle, small);
        return glm::vec2(std::cos(turn), std::sin(turn));
    };
    add(entries, "ANGLE-unit", &reference::gloam_unit_angle, {made_by<glm::vec2>(upper).only_as_drawn()},
        {.absolute = 4e-7}, {0, above_pi});
}

}  // namespace gloam::catalogue
