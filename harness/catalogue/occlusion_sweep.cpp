// SPDX-License-Identifier: MIT
// The parts of the horizon sweep.
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/occlusion_parts.hpp"
#include "reference/occlusion_slices.hpp"

namespace gloam::catalogue {
namespace occlusion_sweep {

using namespace check;
using Slice = reference::GloamSlice;
using Side = reference::GloamSweepSide;

constexpr const char* sweep_file = "gloam/occlusion/sweep.glsl";
constexpr const char* sweep_source = "gloam; the inner integral of Jimenez et al. 2016";
constexpr double half_pi = 1.5707964;

// Slices of view vectors and normals that face the eye at a moderate angle. The method rejects others.
Values slices() {
    return made_by<Slice>([](numeric::Random& random) {
               const glm::vec3 view =
                   glm::normalize(glm::vec3(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), 1));
               const glm::vec3 normal =
                   glm::normalize(glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), 1));
               const auto turn = static_cast<float>(random.uniform(0, 3.1415926));
               return reference::gloam_slice(glm::vec2(std::cos(turn), std::sin(turn)), view, normal);
           })
        .only_as_drawn();
}

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

void append_falloff(Entries& entries) {
    entries.push_back(
        equation<float(unsigned, float)>({.id = "FALLOFF-choice",
                                          .function = "gloam_falloff_at",
                                          .file = "gloam/occlusion/falloff_choice.glsl",
                                          .title = "falloff that a setting chooses, at a share of the radius",
                                          .formula = "step, 1 - x, 1 - x^2, 1 - x^3",
                                          .source = "definition"},
                                         &reference::gloam_falloff_at,
                                         {.domain = {integers(0, 5), uniform(0, 1.2).and_near({1.0})},
                                          .budget = {.absolute = 4e-7},
                                          .codomain = {-0.75, 1}}));
}

void append_ends(Entries& entries) {
    entries.push_back(equation<Side(float)>({.id = "SWEEP-start",
                                             .function = "gloam_sweep_side",
                                             .file = sweep_file,
                                             .title = "a side of a slice of which nothing has been seen",
                                             .formula = "(cos(n + pi / 2), 0, ..., 0)",
                                             .source = sweep_source},
                                            &reference::gloam_sweep_side,
                                            {.domain = {uniform(-1, 1)}, .codomain = {-1, 1}}));
    const Values lengths = either(uniform(0, 2), log_uniform(1e-30, 1e18));
    entries.push_back(equation<float(float, float)>(
        {.id = "SWEEP-distance",
         .function = "gloam_sweep_distance",
         .file = sweep_file,
         .title = "where a surface lies that a tap uncovers",
         .formula = "(before + here) / 2",
         .source = sweep_source},
        &reference::gloam_sweep_distance,
        {.domain = {lengths, lengths}, .budget = {.ulp = 1, .absolute = 1e-37}, .codomain = {0, 1e18}}));
    using Mirror = Slice(Slice, float);
    entries.push_back(equation<Mirror>({.id = "SWEEP-slice",
                                        .function = "gloam_sweep_slice",
                                        .file = sweep_file,
                                        .title = "a slice as one of its sides sees it",
                                        .formula = "n times 1 or -1",
                                        .source = "definition"},
                                       &reference::gloam_sweep_slice,
                                       {.domain = {slices(), uniform(1, 1).and_value(-1.0F).only_as_drawn()},
                                        .codomain = {-half_pi, half_pi}}));
}

void append_taps_of_sides(Entries& entries) {
    using Behind = float(glm::vec2, Slice);
    entries.push_back(equation<Behind>(
        {.id = "SWEEP-behind",
         .function = "gloam_sweep_behind",
         .file = sweep_file,
         .title = "what lies between a direction and the tangent plane",
         .formula = "I(n + pi / 2) - I(h)",
         .source = sweep_source},
        &reference::gloam_sweep_behind,
        {.domain = {unit_vector(2), slices()},
         .budget = {.absolute = 5e-7},
         .codomain = {-half_pi, half_pi},
         .promised = make_predicate<Behind>([](const glm::dvec2& d, const Slice& slice) {
             return std::atan2(std::abs(d.y), d.x) <= static_cast<double>(slice.angle) + half_pi;
         })}));
    using Tap = Side(Side, Slice, glm::vec2, bool, bool, unsigned);
    const Values offsets = vector_of_length(2, uniform(1e-3, 2)).only_as_drawn();
    entries.push_back(
        equation<Tap>({.id = "SWEEP-uncover",
                       .function = "gloam_sweep_uncover",
                       .file = sweep_file,
                       .title = "a side of a slice with what one more tap uncovers",
                       .formula = "sum + D(rho) (I(H) - I(h)), horizon h, where h < H",
                       .source = sweep_source},
                      &reference::gloam_sweep_uncover,
                      {.domain = {sides(), slices(), offsets, booleans(), booleans(), integers(0, 3)},
                       .budget = {.absolute = 8e-7, .backward_ulp = 4},
                       .codomain = {-3, 3}}));
}

// Features: how much of them counts, where they end, and a tap that begins or continues one.
void append_features(Entries& entries) {
    const Values lengths = either(uniform(0, 2), log_uniform(1e-4, 1e4));
    const Values thicknesses = either(uniform(0, 3), log_uniform(1e-3, 1e18));
    entries.push_back(equation<float(float, float, float)>(
        {.id = "SWEEP-share",
         .function = "gloam_sweep_share",
         .file = sweep_file,
         .title = "share of a feature's directions that its thickness covers",
         .formula = "min(1, t w / rise)",
         .source = "gloam"},
        &reference::gloam_sweep_share,
        {.domain = {lengths, log_uniform(1e-4, 1e4), thicknesses},
         .budget = {.ulp = 3, .absolute = 1e-30},
         .codomain = {0, 1}}));
    const Values at = vector({uniform(-1, 1), uniform(0, 1)}).only_as_drawn();
    const Values moderate_thickness = uniform(0, 3).and_value(1e18F).only_as_drawn();
    using End = Side(Side, glm::vec2, float);
    entries.push_back(
        equation<End>({.id = "SWEEP-end",
                       .function = "gloam_sweep_end",
                       .file = sweep_file,
                       .title = "a side of a slice whose feature ends where the surface falls",
                       .formula = "sum + feature min(1, t w / rise) where x < x_last - 0.8 rise",
                       .source = "gloam"},
                      &reference::gloam_sweep_end,
                      {.domain = {sides(), at, moderate_thickness},
                       .budget = {.absolute = 1e-6, .backward_ulp = 4},
                       .codomain = {-3, 3}}));
    using Tap = Side(Side, Slice, glm::vec2, bool, bool, unsigned, float);
    const Values offsets = vector_of_length(2, uniform(1e-3, 2)).only_as_drawn();
    entries.push_back(equation<Tap>(
        {.id = "SWEEP-tap",
         .function = "gloam_sweep_tap",
         .file = sweep_file,
         .title = "a side of a slice with one more tap",
         .formula = "SWEEP-end, then feature + D(rho) (I(H) - I(h)), horizon h, where h < H",
         .source = "gloam"},
        &reference::gloam_sweep_tap,
        {.domain = {sides(), slices(), offsets, booleans(), booleans(), integers(0, 3), moderate_thickness},
         .budget = {.absolute = 2e-6, .backward_ulp = 4},
         .codomain = {-3, 3}}));
}

}  // namespace occlusion_sweep

void append_sweeps(Entries& entries) {
    occlusion_sweep::append_falloff(entries);
    occlusion_sweep::append_ends(entries);
    occlusion_sweep::append_taps_of_sides(entries);
    occlusion_sweep::append_features(entries);
}

}  // namespace gloam::catalogue
