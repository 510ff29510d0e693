// SPDX-License-Identifier: MIT
#include <cmath>

#include "catalogue/geometry_parts.hpp"
#include "catalogue/inputs.hpp"
#include "catalogue/relatives_parts.hpp"
#include "catalogue/rooms.hpp"
#include "numeric/constants.hpp"
#include "reference/geometry.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

using DepthSignature = float(float, float, float);

Values buffer_depths() {
    return either(uniform(0, 1), either(log_uniform(1e-9, 1), uniform(0.999, 1)))
        .and_near({0.5, 1.0})
        .and_special();
}

// Replaces (near, far / near) by the elements (p22, p32) of a projection, one of four kinds with equal
// probability: standard or reversed, finite or infinite far plane. `elements`: returns them for (near, far).
// Special values are kept as drawn.
template <class Elements>
auto projection_elements(Elements elements) {
    return [elements](std::span<Word> words) {
        const auto near = from_word<double>(words[1]);
        const double far = near * from_word<double>(words[2]);
        if (!(near >= 0.01 && near <= 10.0 && far > near && far <= 1e6)) return;
        const glm::dvec2 p = elements(near, far, words[1] % 4U);
        words[1] = to_word(p.x);
        words[2] = to_word(p.y);
    };
}

glm::dvec2 perspective_vk(double near, double far, unsigned kind) {
    const bool infinite = kind % 2U == 1U;
    const glm::dvec2 standard = infinite ? glm::dvec2(-1, -near) : glm::dvec2(far, far * near) / (near - far);
    return kind < 2U ? standard : glm::dvec2(-1 - standard.x, -standard.y);
}

glm::dvec2 perspective_gl(double near, double far, unsigned kind) {
    const bool infinite = kind % 2U == 1U;
    const glm::dvec2 standard =
        infinite ? glm::dvec2(-1, -2 * near) : glm::dvec2(far + near, 2 * far * near) / (near - far);
    return kind < 2U ? standard : -standard;
}

glm::dvec2 orthographic_vk(double near, double far, unsigned kind) {
    const glm::dvec2 standard = glm::dvec2(1, near) / (near - far);
    return kind < 2U ? standard : glm::dvec2(-standard.x, 1 - standard.y);
}

glm::dvec2 orthographic_gl(double near, double far, unsigned kind) {
    const glm::dvec2 standard = glm::dvec2(2, far + near) / (near - far);
    return kind < 2U ? standard : -standard;
}

template <class Elements, class Reference>
void append_depth(Entries& entries, Description description, Reference reference, Elements elements,
                  Question check) {
    description.file = "gloam/geometry/linear_depth.glsl";
    description.source = "the projection solved for depth";
    check.domain =
        Domain{buffer_depths(), log_uniform(0.01, 10).and_special(), log_uniform(1.1, 1e5).and_special()}
            .adjusted(projection_elements(elements));
    check.codomain = {0x1p-126, numeric::infinity};
    entries.push_back(equation<DepthSignature>(std::move(description), reference, std::move(check)));
}

// Elements and depths with which no result overflows or underflows.
bool ordinary_projection(double b, double p22, double p32) {
    return moderate(1e-30, 1e30, b, p22, p32);
}

// True projections have an element of magnitude 1 or more. Smaller elements would cancel against the 1 of
// OpenGL's range.
bool true_perspective_gl(double b, double p22, double p32) {
    return ordinary_projection(b, p22, p32) && !(std::abs(p22) < 1.0);
}
bool true_orthographic_gl(double b, double p22, double p32) {
    return ordinary_projection(b, p22, p32) && !(std::abs(p32) < 1.0);
}

void append_background(Entries& entries) {
    const Values depth = any_float().and_special().and_near({0x1p-126, 3.402823466e38});
    const auto test = [&](std::string id, std::string function, std::string file, std::string title,
                          std::string formula, auto reference) {
        entries.push_back(equation<bool(float)>({.id = std::move(id),
                                                 .function = std::move(function),
                                                 .file = std::move(file),
                                                 .title = std::move(title),
                                                 .formula = std::move(formula),
                                                 .source = "convention"},
                                                reference, {.domain = {depth}}));
    };
    test("FINITE", "gloam_is_finite", "gloam/geometry/finite.glsl", "number that is neither infinite nor NaN",
         "|x| <= FLT_MAX", &reference::gloam_is_finite);
    const auto test_vector = [&]<class V>(V, std::string id, std::string function, auto reference) {
        const Values component = either(uniform(-1, 1), any_float()).and_special().and_near({3.402823466e38});
        entries.push_back(equation<bool(V)>({.id = std::move(id),
                                             .function = std::move(function),
                                             .file = "gloam/geometry/finite.glsl",
                                             .title = "vector that is neither infinite nor NaN",
                                             .formula = "|v_i| <= FLT_MAX",
                                             .source = "convention"},
                                            reference, {.domain = {vector(V::length(), component)}}));
    };
    test_vector(glm::vec2(), "FINITE-2", "gloam_is_finite2", &reference::gloam_is_finite2);
    test_vector(glm::vec3(), "FINITE-3", "gloam_is_finite3", &reference::gloam_is_finite3);
    test_vector(glm::vec4(), "FINITE-4", "gloam_is_finite4", &reference::gloam_is_finite4);
    test("BACKGROUND", "gloam_is_background", "gloam/geometry/background.glsl",
         "depth that stands for no geometry", "not (0 < d < infinity)", &reference::gloam_is_background);
}

void append_background_depths(Entries& entries) {
    entries.push_back(equation<float()>({.id = "BACKGROUND-depth",
                                         .function = "gloam_background_depth",
                                         .file = "gloam/geometry/background.glsl",
                                         .title = "depth of a pixel without geometry",
                                         .formula = "+infinity",
                                         .source = "convention"},
                                        &reference::gloam_background_depth,
                                        {.codomain = {numeric::infinity, numeric::infinity}}));
    const Values part = either(signed_log_uniform(1e-3, 1e3), signed_log_uniform(1e-30, 1e30));
    entries.push_back(equation<float(float, float)>(
        {.id = "DEPTH-quotient",
         .function = "gloam_depth_quotient",
         .file = "gloam/geometry/linear_depth.glsl",
         .title = "quotient that is a depth, or the background",
         .formula = "a / b; +infinity unless positive and finite",
         .source = "convention"},
        &reference::gloam_depth_quotient,
        {.domain = {part.and_special(), part.and_special().and_near({0x1p126})},
         .budget = {.ulp = 1.5},
         .codomain = {0x1p-126, numeric::infinity},
         .promised = make_predicate<float(float, float)>(
             [](double a, double b) { return moderate(1e-30, 1e30, a) && !(std::abs(a / b) < 1e-37); })}));
}

}  // namespace

void append_depths(Entries& entries) {
    append_background(entries);
    append_background_depths(entries);
    append_depth(entries,
                 {.id = "DEPTH-perspective-vk",
                  .function = "gloam_linear_depth_perspective_vk",
                  .title = "eye-linear depth, perspective, depth range [0, 1]",
                  .formula = "d = P32 / (b + P22)"},
                 &reference::gloam_linear_depth_perspective_vk, perspective_vk,
                 {.budget = {.ulp = 3}, .promised = make_predicate<DepthSignature>(ordinary_projection)});
    append_depth(entries,
                 {.id = "DEPTH-perspective-gl",
                  .function = "gloam_linear_depth_perspective_gl",
                  .title = "eye-linear depth, perspective, depth range [-1, 1]",
                  .formula = "d = P32 / (2 b - 1 + P22)"},
                 &reference::gloam_linear_depth_perspective_gl, perspective_gl,
                 {.budget = {.ulp = 3.5}, .promised = make_predicate<DepthSignature>(true_perspective_gl)});
    append_depth(entries,
                 {.id = "DEPTH-orthographic-vk",
                  .function = "gloam_linear_depth_orthographic_vk",
                  .title = "eye-linear depth, orthographic, depth range [0, 1]",
                  .formula = "d = (P32 - b) / P22"},
                 &reference::gloam_linear_depth_orthographic_vk, orthographic_vk,
                 {.budget = {.ulp = 3}, .promised = make_predicate<DepthSignature>(ordinary_projection)});
    append_depth(entries,
                 {.id = "DEPTH-orthographic-gl",
                  .function = "gloam_linear_depth_orthographic_gl",
                  .title = "eye-linear depth, orthographic, depth range [-1, 1]",
                  .formula = "d = (P32 + 1 - 2 b) / P22"},
                 &reference::gloam_linear_depth_orthographic_gl, orthographic_gl,
                 {.budget = {.ulp = 4}, .promised = make_predicate<DepthSignature>(true_orthographic_gl)});
}

void append_geometry(Entries& entries) {
    append_depths(entries);
    append_positions(entries);
    append_normals(entries);
    append_reprojections(entries);
    append_cameras(entries);
    append_pixels(entries);
    append_geometry_lengths(entries);
}

}  // namespace gloam::catalogue
