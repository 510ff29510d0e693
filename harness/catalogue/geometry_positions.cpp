// SPDX-License-Identifier: MIT
#include <cmath>

#include "catalogue/geometry_parts.hpp"
#include "catalogue/inputs.hpp"
#include "reference/geometry_camera.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr double huge = 3.5e38;
constexpr const char* file = "gloam/geometry/position.glsl";

Values depths() {
    return log_uniform(1e-3, 1e6).and_special().and_near({0x1p-126});
}
Values ndcs() {
    return vector(2, uniform(-1.1, 1.1)).and_special();
}
Values scales() {
    return projection_scales().and_special();
}

// Between these no product or quotient of the formulas overflows or underflows.
constexpr double smallest = 1e-12;
constexpr double largest = 1e12;

using PositionSignature = glm::vec3(glm::vec2, float, glm::vec2);
using NdcSignature = glm::vec2(glm::vec3, glm::vec2);

Question position_check(double ulp) {
    return {.domain = {ndcs(), depths(), scales()},
            .budget = {.ulp = ulp},
            .codomain = {-huge, huge},
            .promised = make_predicate<PositionSignature>([](glm::dvec2 ndc, double depth, glm::dvec2 scale) {
                return moderate(smallest, largest, ndc, depth, scale);
            })};
}

Question ndc_check(double ulp) {
    const Values position =
        vector({signed_log_uniform(1e-3, 1e3), signed_log_uniform(1e-3, 1e3), signed_log_uniform(1e-3, 1e4)});
    return {.domain = {position.and_special(), scales()},
            .budget = {.ulp = ulp},
            .codomain = {-huge, huge},
            .promised = make_predicate<NdcSignature>(
                [](glm::dvec3 at, glm::dvec2 scale) { return moderate(smallest, largest, at, scale); })};
}

void append_unprojection(Entries& entries) {
    entries.push_back(equation<PositionSignature>({.id = "POSITION-perspective",
                                                   .function = "gloam_view_position_perspective",
                                                   .file = file,
                                                   .title = "view-space position under a pixel, perspective",
                                                   .formula = "(ndc.x / P00, ndc.y / P11, -1) d",
                                                   .source = "inverse of the projection"},
                                                  &reference::gloam_view_position_perspective,
                                                  position_check(3)));
    entries.push_back(equation<PositionSignature>({.id = "POSITION-orthographic",
                                                   .function = "gloam_view_position_orthographic",
                                                   .file = file,
                                                   .title = "view-space position under a pixel, orthographic",
                                                   .formula = "(ndc.x / P00, ndc.y / P11, -d)",
                                                   .source = "inverse of the projection"},
                                                  &reference::gloam_view_position_orthographic,
                                                  position_check(1)));
}

void append_projection(Entries& entries) {
    entries.push_back(
        equation<NdcSignature>({.id = "NDC-perspective",
                                .function = "gloam_ndc_perspective",
                                .file = file,
                                .title = "normalised device coordinates of a position, perspective",
                                .formula = "(P00 x, P11 y) / -z",
                                .source = "the projection"},
                               &reference::gloam_ndc_perspective, ndc_check(3)));
    entries.push_back(
        equation<NdcSignature>({.id = "NDC-orthographic",
                                .function = "gloam_ndc_orthographic",
                                .file = file,
                                .title = "normalised device coordinates of a position, orthographic",
                                .formula = "(P00 x, P11 y)",
                                .source = "the projection"},
                               &reference::gloam_ndc_orthographic, ndc_check(1)));
}

using UvRadius = glm::vec2(float, float, glm::vec2);
using PixelRadius = glm::vec2(float, float, glm::vec2, glm::ivec2);

template <class Signature, class Reference>
void append_radius(Entries& entries, std::string id, std::string function, std::string formula,
                   Reference reference, double ulp) {
    Domain domain{log_uniform(1e-3, 1e2).and_special(), depths(), scales()};
    std::function<bool(std::span<const Word>)> promised;
    const auto usual = [](double radius, double depth, glm::dvec2 scale) {
        return moderate(smallest, largest, radius, depth, scale) && !std::isinf(radius);
    };
    if constexpr (std::is_same_v<Signature, PixelRadius>) {
        domain = Domain{log_uniform(1e-3, 1e2).and_special(), depths(), scales(),
                        vector(2, log_integers(16384).and_near_integers({0}))};
        promised = make_predicate<Signature>([usual](double radius, double depth, glm::dvec2 scale,
                                                     glm::ivec2) { return usual(radius, depth, scale); });
    } else {
        promised = make_predicate<Signature>(usual);
    }
    entries.push_back(equation<Signature>(
        {.id = std::move(id),
         .function = std::move(function),
         .file = "gloam/geometry/projected_radius.glsl",
         .title = "projected radius of a world length",
         .formula = std::move(formula),
         .source = "the projection"},
        reference, {.domain = domain, .budget = {.ulp = ulp}, .codomain = {0, huge}, .promised = promised}));
}

void append_coordinates(Entries& entries) {
    entries.push_back(equation<float(float)>(
        {.id = "LENGTH",
         .function = "gloam_positive_length",
         .file = "gloam/geometry/projected_radius.glsl",
         .title = "number read as a length",
         .formula = "x inside [0, FLT_MAX], else the nearer end; 0 for NaN",
         .source = "convention"},
        &reference::gloam_positive_length,
        {.domain = {either(any_float(), uniform(-2, 2)).and_special()}, .codomain = {0, huge}}));
    const Values coordinate = either(integers(-16, 8192), integers(-2147483648L, 2147483647L));
    entries.push_back(equation<glm::vec2(glm::ivec2, glm::ivec2)>(
        {.id = "NDC-pixel",
         .function = "gloam_ndc_from_pixel",
         .file = file,
         .title = "normalised device coordinates of a pixel's centre",
         .formula = "(2 x + 1 - width) / width",
         .source = "definition of the pixel centre"},
        &reference::gloam_ndc_from_pixel,
        {.domain = {vector(2, coordinate),
                    vector(2, log_integers(4194304).and_near_integers({0, -2147483647L}))},
         .budget = {.ulp = 1},
         .codomain = {-1e10, 1e10},
         .promised = make_predicate<glm::vec2(glm::ivec2, glm::ivec2)>([](glm::ivec2 pixel, glm::ivec2) {
             return std::abs(static_cast<double>(pixel.x)) <= 4194304 &&
                    std::abs(static_cast<double>(pixel.y)) <= 4194304;
         })}));
    entries.push_back(equation<glm::vec2(glm::vec2)>(
        {.id = "UV-ndc",
         .function = "gloam_uv_from_ndc",
         .file = file,
         .title = "texture coordinates of normalised device coordinates",
         .formula = "ndc / 2 + 1/2",
         .source = "convention"},
        &reference::gloam_uv_from_ndc,
        {.domain = {ndcs()}, .budget = {.ulp = 1}, .codomain = {-huge, huge}}));
}

}  // namespace

void append_positions(Entries& entries) {
    append_coordinates(entries);
    append_unprojection(entries);
    append_projection(entries);
    append_radius<UvRadius>(entries, "RADIUS-uv", "gloam_projected_radius_uv", "R (|P00|, |P11|) / (2 d)",
                            &reference::gloam_projected_radius_uv, 3);
    append_radius<PixelRadius>(entries, "RADIUS-px", "gloam_projected_radius_pixels",
                               "R (|P00| W, |P11| H) / (2 d)", &reference::gloam_projected_radius_pixels,
                               4.5);
    append_radius<UvRadius>(entries, "RADIUS-uv-orthographic", "gloam_projected_radius_uv_orthographic",
                            "R (|P00|, |P11|) / 2", &reference::gloam_projected_radius_uv_orthographic, 1);
    append_radius<PixelRadius>(entries, "RADIUS-px-orthographic",
                               "gloam_projected_radius_pixels_orthographic", "R (|P00| W, |P11| H) / 2",
                               &reference::gloam_projected_radius_pixels_orthographic, 3);
}

}  // namespace gloam::catalogue
