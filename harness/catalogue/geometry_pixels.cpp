// SPDX-License-Identifier: MIT
#include <cmath>

#include "catalogue/geometry_parts.hpp"
#include "catalogue/inputs.hpp"
#include "reference/geometry_camera.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr double huge = 3.5e38;
constexpr const char* borders = "gloam/geometry/borders.glsl";

Values sizes() {
    return vector(2, log_integers(16384).and_near_integers({0, -2147483647L, 4194304}));
}
Values uvs() {
    return vector(2, uniform(-0.2, 1.2).and_near({1.0})).and_special();
}

// One coordinate in four is put on the border of a pixel, or the float before or after it.
void place_at_borders(std::span<Word> words) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto size = from_word<int>(words[2 + axis]);
        const Word lot = words[axis];
        if (lot % 4U != 2U || size < 1) continue;  // no special float ends in these bits
        const auto pixel = static_cast<double>((lot / 4U) % static_cast<Word>(size));
        words[axis] = to_word(pixel / size) + (lot / 64U) % 3U - 1U;
    }
}

using UvSignature = glm::vec2(glm::vec2, glm::vec2);

Question uv_check(Budget budget) {
    const Values guard = vector(2, uniform(0, 1).and_near({0.05, 0.1})).and_special();
    return {.domain = {uvs(), guard},
            .budget = budget,
            .codomain = {-huge, huge},
            .promised = make_predicate<UvSignature>([](glm::dvec2 uv, glm::dvec2 guard_band) {
                const auto usual = [](double x) { return !(std::abs(x) > 1e9 && std::isfinite(x)); };
                return usual(uv.x) && usual(uv.y) && guard_band.x >= 0 && guard_band.x <= 1 &&
                       guard_band.y >= 0 && guard_band.y <= 1;
            })};
}

void append_guard_uv(Entries& entries) {
    entries.push_back(equation<UvSignature>({.id = "TSSAO-BORDER-inner",
                                             .function = "gloam_guard_band_inner_uv",
                                             .file = borders,
                                             .title = "texture coordinates in the crop of a guard band",
                                             .formula = "(1 + 2 g) uv - g",
                                             .source = "TSSAO (Mattausch et al.), frame borders"},
                                            &reference::gloam_guard_band_inner_uv,
                                            uv_check({.ulp = 1.5, .absolute = 3e-7})));
    entries.push_back(equation<UvSignature>({.id = "TSSAO-BORDER-outer",
                                             .function = "gloam_guard_band_outer_uv",
                                             .file = borders,
                                             .title = "texture coordinates in the image with its guard band",
                                             .formula = "(uv + g) / (1 + 2 g)",
                                             .source = "TSSAO (Mattausch et al.), frame borders"},
                                            &reference::gloam_guard_band_outer_uv,
                                            uv_check({.ulp = 4, .absolute = 1e-7})));
    entries.push_back(equation<float(float, float)>(
        {.id = "TSSAO-BORDER-tan",
         .function = "gloam_guard_band_tan_half_fov",
         .file = borders,
         .title = "half field of view with the guard band",
         .formula = "tan' = (1 + 2 g) tan",
         .source = "TSSAO (Mattausch et al.), frame borders"},
        &reference::gloam_guard_band_tan_half_fov,
        {.domain = {log_uniform(0.05, 10).and_special(), uniform(0, 1).and_special()},
         .budget = {.ulp = 3},
         .codomain = {-huge, huge},
         .promised = make_predicate<float(float, float)>(
             [](double, double guard) { return guard >= 0 && guard <= 1; })}));
}

template <class Signature, class Reference>
void append_guard(Entries& entries, Description description, Reference reference, Budget budget,
                  Codomain codomain) {
    description.file = borders;
    description.source = "TSSAO (Mattausch et al.), frame borders";
    entries.push_back(equation<Signature>(
        std::move(description), reference,
        {.domain = {sizes(),
                    either(uniform(0, 1), uniform(0.05, 0.1)).and_near({0.05, 0.1, 0.25, 0.5}).and_special()},
         .budget = budget,
         .codomain = codomain}));
}

void append_nearest(Entries& entries) {
    entries.push_back(
        equation<int(float, int)>({.id = "TSSAO-7-index",
                                   .function = "gloam_nearest_index",
                                   .file = "gloam/geometry/pixel_center.glsl",
                                   .title = "pixel of a texture coordinate along one axis",
                                   .formula = "floor(u resolution), inside the image",
                                   .source = "TSSAO (Mattausch et al.), eq 7"},
                                  &reference::gloam_nearest_index,
                                  {.domain = {uniform(-0.2, 1.2).and_near({0.5, 1.0}).and_special(),
                                              log_integers(16384).and_near_integers({0, -2147483647L})},
                                   .budget = {.backward_ulp = 1}}));
    entries.push_back(equation<glm::ivec2(glm::vec2, glm::ivec2)>(
        {.id = "TSSAO-7-pixel",
         .function = "gloam_nearest_pixel",
         .file = "gloam/geometry/pixel_center.glsl",
         .title = "pixel of a texture coordinate",
         .formula = "floor(uv resolution), inside the image",
         .source = "TSSAO (Mattausch et al.), eq 7"},
        &reference::gloam_nearest_pixel,
        {.domain = Domain{uvs(), sizes()}.adjusted(place_at_borders), .budget = {.backward_ulp = 1}}));
    entries.push_back(equation<glm::vec2(glm::vec2, glm::ivec2)>(
        {.id = "TSSAO-7",
         .function = "gloam_pixel_center",
         .file = "gloam/geometry/pixel_center.glsl",
         .title = "pixel centre of a texture coordinate",
         .formula = "(floor(uv resolution) + 1/2) / resolution",
         .source = "TSSAO (Mattausch et al.), eq 7 corrected"},
        &reference::gloam_pixel_center,
        {.domain = Domain{uvs(), sizes()}.adjusted(place_at_borders),
         .budget = {.ulp = 1.5, .backward_ulp = 1},
         .codomain = {0, 1}}));
}

void append_guard_sizes(Entries& entries) {
    append_guard<glm::ivec2(glm::ivec2, float)>(entries,
                                                {.id = "TSSAO-BORDER-width",
                                                 .function = "gloam_guard_band_border",
                                                 .title = "width of the guard band in pixels",
                                                 .formula = "floor(g size + 1/2)"},
                                                &reference::gloam_guard_band_border, {.backward_ulp = 1},
                                                {0, 4194305});
    append_guard<glm::ivec2(glm::ivec2, float)>(entries,
                                                {.id = "TSSAO-BORDER-size",
                                                 .function = "gloam_guard_band_size",
                                                 .title = "size of the image with its guard band",
                                                 .formula = "size + 2 border"},
                                                &reference::gloam_guard_band_size, {.backward_ulp = 1},
                                                {0, 12582915});
    append_guard<glm::vec2(glm::ivec2, float)>(entries,
                                               {.id = "TSSAO-BORDER-guard",
                                                .function = "gloam_guard_band_guard",
                                                .title = "guard actually rendered",
                                                .formula = "border / size"},
                                               &reference::gloam_guard_band_guard,
                                               {.ulp = 5, .backward_ulp = 1}, {0, 1});
}

}  // namespace

void append_pixels(Entries& entries) {
    append_nearest(entries);
    entries.push_back(equation<bool(glm::vec2)>(
        {.id = "INSIDE",
         .function = "gloam_inside_unit",
         .file = "gloam/geometry/pixel_center.glsl",
         .title = "texture coordinates inside the image",
         .formula = "0 <= u, v <= 1",
         .source = "convention"},
        &reference::gloam_inside_unit,
        {.domain = {vector(2, uniform(-0.2, 1.2).and_near({0.0, 1.0})).and_special()}}));
    const Values pixel = vector(2, integers(-100, 5000).and_near_integers({0, 2147483647, -2147483647L}));
    entries.push_back(equation<glm::ivec2(glm::ivec2, glm::ivec2)>(
        {.id = "TSSAO-BORDER",
         .function = "gloam_clamp_to_edge",
         .file = borders,
         .title = "nearest pixel of the image",
         .formula = "clamp(p, 0, size - 1)",
         .source = "TSSAO (Mattausch et al.), frame borders"},
        &reference::gloam_clamp_to_edge, {.domain = {pixel, sizes()}}));
    append_guard_sizes(entries);
    append_guard_uv(entries);
}

}  // namespace gloam::catalogue
