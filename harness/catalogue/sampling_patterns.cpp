// SPDX-License-Identifier: MIT
#include "catalogue/inputs.hpp"
#include "catalogue/sampling_parts.hpp"
#include "reference/sampling.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

// Sets one input in eight to the distance itself, where the result changes.
void place_at_distance(std::span<Word> words) {
    if (words[0] % 8U != 2U) return;  // no special float ends in these bits
    const glm::dvec2 a(from_word<double>(words[0]), from_word<double>(words[1]));
    const glm::dvec2 b(from_word<double>(words[2]), from_word<double>(words[3]));
    words[4] = to_word(glm::distance(a, b));
}

void append_poisson(Entries& entries) {
    const Values point = vector_of_length(2, uniform(0, 1)).and_special();
    const auto representable = [](glm::dvec2 a, glm::dvec2 b, double distance) {
        const double apart = glm::distance(a, b);
        // Squares of values outside this range overflow or underflow.
        return !(distance > 0 && distance < 1e-18) && !(apart > 0 && apart < 1e-18) && !(apart > 1e18) &&
               !(distance > 1e18);
    };
    entries.push_back(equation<bool(glm::vec2, glm::vec2, float)>(
        {.id = "POISSON",
         .function = "gloam_poisson_accepts",
         .file = "gloam/sampling/poisson.glsl",
         .title = "Poisson-disc condition",
         .formula = "|s_i - s_j| > d",
         .source = "definition"},
        &reference::gloam_poisson_accepts,
        {.domain = Domain{point, point, uniform(0, 2).and_special()}.adjusted(place_at_distance),
         .budget = {.backward_ulp = 3},
         .promised = make_predicate<bool(glm::vec2, glm::vec2, float)>(representable)}));
    entries.push_back(equation<glm::vec3(glm::vec2)>(
        {.id = "POISSON-lift",
         .function = "gloam_hemisphere_lift",
         .file = "gloam/sampling/poisson.glsl",
         .title = "disc point lifted onto the hemisphere",
         .formula = "(x, y, sqrt(1 - x^2 - y^2))",
         .source = "Sourimant et al. 2011"},
        &reference::gloam_hemisphere_lift,
        {.domain = {either(vector_of_length(2, either(uniform(0, 1), either(uniform(0.9999, 1.0001),
                                                                            uniform(0.9999995, 1.0000005)))),
                           vector_of_length(2, log_uniform(1e-37, 1e38)))
                        .and_special()},
         .budget = {.absolute = 6e-6},
         .codomain = {-1.000001, 1.000001}}));
}

}  // namespace

void append_sample_patterns(Entries& entries) {
    const Values count = log_integers(32768).and_near_integers({0, 32768, 2147483647});
    const Values turns =
        either(integers(-64, 64), integers(-2147483648L, 2147483647L)).and_near_integers({2147483647});
    entries.push_back(equation<glm::vec2(int, int, int)>(
        {.id = "SPIRAL-point",
         .function = "gloam_spiral_point",
         .file = "gloam/sampling/spiral.glsl",
         .title = "point of a spiral",
         .formula = "a = (i + 1/2) / n; a (cos(2 pi a turns), sin(2 pi a turns))",
         .source = "McGuire, Mara and Luebke 2012 (Scalable Ambient Obscurance)"},
        &reference::gloam_spiral_point,
        {.domain = {count, count, turns}, .budget = {.absolute = 5e-7}, .codomain = {-1.000001, 1.000001}}));
    entries.push_back(equation<glm::vec2(int, int, int, float)>(
        {.id = "SPIRAL",
         .function = "gloam_spiral_tap",
         .file = "gloam/sampling/spiral.glsl",
         .title = "tap of a spiral",
         .formula = "a = (i + 1/2) / n; a (cos(2 pi a turns + phase), sin(2 pi a turns + phase))",
         .source = "McGuire, Mara and Luebke 2012 (Scalable Ambient Obscurance)"},
        &reference::gloam_spiral_tap,
        {.domain = {count, count, turns, uniform(-7, 7).and_near({65536.0}).and_special()},
         .budget = {.absolute = 5e-7},
         .codomain = {-1.000001, 1.000001}}));
    append_poisson(entries);
    entries.push_back(equation<glm::vec2(glm::vec2, int)>(
        {.id = "PAIRS",
         .function = "gloam_paired_sample",
         .file = "gloam/sampling/pairs.glsl",
         .title = "sample of a kernel of opposite pairs",
         .formula = "s_(2m) = s, s_(2m+1) = -s",
         .source = "Loos and Sloan 2010"},
        &reference::gloam_paired_sample,
        {.domain = {vector_of_length(2, uniform(0, 1)).and_special(), integers(-8, 64)},
         .codomain = {-3.5e38, 3.5e38}}));
}

}  // namespace gloam::catalogue
