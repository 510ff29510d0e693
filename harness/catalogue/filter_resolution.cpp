// SPDX-License-Identifier: MIT
// An image of half the resolution: which pixels it stands for, and how its result comes back to full size.
#include <cmath>

#include "catalogue/inputs.hpp"
#include "catalogue/relatives_parts.hpp"
#include "reference/filter.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr const char* half_file = "gloam/filter/half_resolution.glsl";
constexpr const char* upsample_file = "gloam/filter/upsample.glsl";

void append_half(Entries& entries) {
    const Values size = integers(0, 1 << 30);
    entries.push_back(equation<glm::ivec2(glm::ivec2)>(
        {.id = "HALF-size",
         .function = "gloam_half_size",
         .file = half_file,
         .title = "size of an image of half the resolution",
         .formula = "(n + 1) / 2, rounded down",
         .source = "definition"},
        &reference::gloam_half_size, {.domain = {either(vector(2, integers(0, 9)), vector(2, size))}}));
    entries.push_back(equation<glm::ivec2(glm::ivec2)>(
        {.id = "HALF-source",
         .function = "gloam_half_source",
         .file = half_file,
         .title = "full-size pixel that a half-size pixel stands for",
         .formula = "2 p",
         .source = "definition"},
        &reference::gloam_half_source, {.domain = {vector(2, integers(-(1 << 29), 1 << 29))}}));
}

void append_half_space(Entries& entries) {
    entries.push_back(equation<float(float, int)>(
        {.id = "HALF-shift",
         .function = "gloam_half_shift",
         .file = half_file,
         .title = "between the rays of a half-size pixel and of its source",
         .formula = "1 / (n p), n even; 0, n odd",
         .source = "derived"},
        &reference::gloam_half_shift,
        {.domain = {either(signed_log_uniform(0.1, 10), signed_log_uniform(1e-12, 1e12)).and_special(),
                    either(integers(-2, 9), log_integers(1 << 24))},
         .budget = {.ulp = 3.5},
         .codomain = {-5e8, 5e8}}));
    using Normal = glm::vec3(glm::vec3, glm::vec2);
    entries.push_back(equation<Normal>(
        {.id = "HALF-normal",
         .function = "gloam_half_normal",
         .file = half_file,
         .title = "normal in the view space of the half-size image",
         .formula = "(n.xy, n.z + shift . n.xy), normalised",
         .source = "derived"},
        &reference::gloam_half_normal,
        {.domain = {unit_vector(3).and_special(),
                    either(vector(2, signed_log_uniform(1e-5, 0.35)), vector(2, constant(0.0F)))},
         .budget = {.absolute = 4e-7},
         .codomain = {-1.000001, 1.000001},
         .promised = make_predicate<Normal>([](glm::dvec3 normal, glm::dvec2 shift) {
             return moderate(1e-18, 1e18, normal) && moderate(0.0, 0.5, shift);
         })}));
}

// Depths of a surface and of what is in front of it or behind.
float any_depth(numeric::Random& random, float around) {
    if (random.below(16) == 0) return random.below(2) == 0 ? INFINITY : 0.0F;
    const double spread = random.below(2) == 0 ? 0.02 : 2.0;
    return around * static_cast<float>(std::exp(random.uniform(-spread, spread)));
}

Values four_depths() {
    return made_by<glm::vec4>([](numeric::Random& random) {
        glm::vec4 all(0);
        for (int i = 0; i < 4; ++i) all[i] = any_depth(random, 1.0F);
        return all;
    });
}

// Whether no two pixels are equally far from a depth within rounding.
bool one_is_nearest(double depth, glm::dvec4 depths) {
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < i; ++k) {
            const double a = std::abs(depths[i] - depth);
            const double b = std::abs(depths[k] - depth);
            if (std::isfinite(a) && std::isfinite(b) && !(std::abs(a - b) > 1e-6 * (a + b))) return false;
        }
    }
    return true;
}

void append_upsampling(Entries& entries) {
    const Values depth = either(uniform(0.95, 1.05), log_uniform(0.1, 10)).and_special();
    entries.push_back(equation<bool(float, float, float, bool)>(
        {.id = "UPSAMPLE-continues",
         .function = "gloam_upsample_continues",
         .file = upsample_file,
         .title = "whether a surface continues through two pixels around another",
         .formula = "|(d / a + d / b) / 2 - 1| <= 0.006; orthographic |(a + b) / (2 d) - 1| <= 0.006",
         .source = "derived"},
        &reference::gloam_upsample_continues,
        {.domain = {depth, depth, depth, booleans()}, .budget = {.backward_ulp = 2}}));
    entries.push_back(equation<float(float, glm::vec4, glm::vec4)>(
        {.id = "UPSAMPLE-nearest",
         .function = "gloam_upsample_nearest",
         .file = upsample_file,
         .title = "value of the pixel nearest in depth",
         .formula = "v_i where |d_i - d| is least",
         .source = "derived"},
        &reference::gloam_upsample_nearest,
        {.domain = {uniform(0.9, 1.1), four_depths(), vector(4, uniform(0, 1))},
         .budget = {.backward_ulp = 1},
         .codomain = {0, 1}}));
}

void append_upsample_of_four(Entries& entries) {
    using Upsample = float(float, glm::vec4, glm::vec4, bool);
    entries.push_back(equation<Upsample>(
        {.id = "UPSAMPLE",
         .function = "gloam_upsample",
         .file = upsample_file,
         .title = "occlusion of a full-size pixel from half-size pixels",
         .formula =
             "mean of the opposite pairs through which the surface continues, else the nearest in depth",
         .source = "derived"},
        &reference::gloam_upsample,
        {.domain = {either(uniform(0.97, 1.03), log_uniform(0.1, 10)).and_special(), four_depths(),
                    vector(4, uniform(0, 1).and_special()), booleans()},
         .budget = {.absolute = 1.2e-7, .backward_ulp = 2},
         .codomain = {0, 1},
         .promised =
             make_predicate<Upsample>([](double depth, glm::dvec4 depths, glm::dvec4, bool orthographic) {
                 return one_is_nearest(depth, depths) ||
                        reference::gloam_upsample_continues(depth, depths.x, depths.w, orthographic) ||
                        reference::gloam_upsample_continues(depth, depths.y, depths.z, orthographic);
             })}));
}

}  // namespace

void append_filter_resolution(Entries& entries) {
    append_half(entries);
    append_half_space(entries);
    append_upsampling(entries);
    append_upsample_of_four(entries);
}

}  // namespace gloam::catalogue
