// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>

#include "catalogue/camera_inputs.hpp"
#include "catalogue/geometry_parts.hpp"
#include "catalogue/inputs.hpp"
#include "reference/geometry.hpp"
#include "reference/geometry_camera.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;
using Camera = reference::GloamCamera;

constexpr const char* file = "gloam/geometry/camera.glsl";
constexpr double huge = 3.5e38;
constexpr double smallest = 1e-12;
constexpr double largest = 1e12;

using PlaneDepth = float(glm::ivec2, glm::vec3, glm::vec3, Camera);

// Neither of the products that determine the depth cancels by more than a factor of 4.
bool well_conditioned(glm::ivec2 pixel, glm::dvec3 point, glm::dvec3 normal, const Camera& c) {
    if (!moderate(smallest, largest, point, normal, c.p00_p11)) return false;
    const reference::GloamCamera camera{glm::dvec2(c.p00_p11), c.size, c.orthographic};
    const glm::dvec3 ray = reference::gloam_camera_position(pixel, 1.0, camera);
    const glm::dvec3 start = c.orthographic ? glm::dvec3(ray.x, ray.y, 0.0) : glm::dvec3(0.0);
    const auto clear = [](glm::dvec3 a, glm::dvec3 b) {
        const glm::dvec3 products = glm::abs(a * b);
        return std::abs(glm::dot(a, b)) * 4.0 >= products.x + products.y + products.z;
    };
    return clear(normal, ray - start) && clear(normal, point - start);
}

Values view_positions() {
    const Values coordinate = either(uniform(-1, 1), signed_log_uniform(1e-3, 1e3));
    return vector({coordinate, coordinate, uniform(1, 4)}).and_special();
}
Values depths() {
    return log_uniform(1e-3, 1e6).and_special();
}

void append_surface(Entries& entries) {
    entries.push_back(equation<bool(glm::vec3)>(
        {.id = "POSITION-surface",
         .function = "gloam_is_surface_position",
         .file = "gloam/geometry/surface_position.glsl",
         .title = "whether a position is one of a surface",
         .formula = "finite and not the zero vector",
         .source = "convention"},
        &reference::gloam_is_surface_position,
        {.domain = {vector(3, uniform(-4, 4)).and_value(glm::vec3(0)).and_special()}}));
}

void append_uv(Entries& entries) {
    entries.push_back(equation<glm::vec2(glm::vec3, Camera)>(
        {.id = "CAMERA-uv",
         .function = "gloam_camera_uv",
         .file = file,
         .title = "texture coordinates of a view-space position",
         .formula = "ndc / 2 + 1/2, ndc of either projection",
         .source = "the projection"},
        &reference::gloam_camera_uv,
        {.domain = Domain{view_positions(), cameras()}.adjusted(place_before_camera(0, 3)),
         .budget = {.ulp = 4, .absolute = 2e-7},
         .codomain = {-huge, huge},
         .promised = make_predicate<glm::vec2(glm::vec3, Camera)>(
             [](glm::dvec3 at, const Camera& c) { return moderate(smallest, largest, at, c.p00_p11); })}));
}

void append_position(Entries& entries) {
    const Values pixel = vector(2, either(integers(-4, 64), integers(-4194304, 4194304)));
    entries.push_back(equation<glm::vec3(glm::ivec2, float, Camera)>(
        {.id = "CAMERA-position",
         .function = "gloam_camera_position",
         .file = file,
         .title = "view-space position of the surface under a pixel's centre",
         .formula = "(ndc.x / P00, ndc.y / P11, -1) d, or (ndc.x / P00, ndc.y / P11, -d)",
         .source = "inverse of the projection"},
        &reference::gloam_camera_position,
        {.domain = {pixel, depths(), cameras()},
         .budget = {.ulp = 3},
         .codomain = {-huge, huge},
         .promised =
             make_predicate<glm::vec3(glm::ivec2, float, Camera)>([](glm::ivec2, double d, const Camera& c) {
                 return moderate(smallest, largest, d, c.p00_p11);
             })}));
}

void append_radius(Entries& entries) {
    entries.push_back(equation<glm::vec2(float, float, Camera)>(
        {.id = "CAMERA-radius",
         .function = "gloam_camera_radius",
         .file = file,
         .title = "projected radius of a world length",
         .formula = "R (|P00|, |P11|) / (2 d), or R (|P00|, |P11|) / 2",
         .source = "the projection"},
        &reference::gloam_camera_radius,
        {.domain = {log_uniform(1e-3, 1e2).and_special(), depths(), cameras()},
         .budget = {.ulp = 3},
         .codomain = {0, huge},
         .promised = make_predicate<glm::vec2(float, float, Camera)>([](double r, double d, const Camera& c) {
             return moderate(smallest, largest, r, d, c.p00_p11) && !(r > largest);
         })}));
}

void append_plane(Entries& entries) {
    entries.push_back(equation<PlaneDepth>(
        {.id = "CAMERA-plane",
         .function = "gloam_plane_depth",
         .file = "gloam/geometry/plane_depth.glsl",
         .title = "depth at which a pixel's view ray meets a plane",
         .formula = "t with n . (ray(t) - point) = 0",
         .source = "ray and plane; keeps a bare plane open in TSSAO-3"},
        &reference::gloam_plane_depth,
        {.domain = Domain{image_pixel(), view_positions(), unit_vector(3).and_special(), cameras()}.adjusted(
             place_before_camera(2, 8)),
         .budget = {.ulp = 14},
         .codomain = {0, std::numeric_limits<double>::infinity()},
         .promised = make_predicate<PlaneDepth>(well_conditioned),
         .scenarios = {{.name = "40 x 30", .size = {40, 30}}}}));
}

}  // namespace

void append_cameras(Entries& entries) {
    append_surface(entries);
    append_uv(entries);
    append_position(entries);
    append_radius(entries);
    append_plane(entries);
}

}  // namespace gloam::catalogue
