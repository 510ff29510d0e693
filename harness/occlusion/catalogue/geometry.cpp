// SPDX-License-Identifier: MIT
// Depths, positions and normals.
#include <cmath>

#include "catalogue/inputs.hpp"
#include "numeric/numbers.hpp"
#include "reference/geometry.hpp"
#include "reference/geometry_camera.hpp"

namespace gloam::catalogue {
namespace {

using namespace judge;
using namespace subject;

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

// The depth of a projection of four kinds, with the elements that `elements` returns.
void add_depth(Entries& entries, const char* id, double (*reference)(double, double, double),
               glm::dvec2 (*elements)(double, double, unsigned), double ulp,
               bool (*promised)(double, double, double)) {
    add(entries, id, reference,
        Domain{buffer_depths(), log_uniform(0.01, 10).and_special(), log_uniform(1.1, 1e5).and_special()}
            .adjusted(projection_elements(elements)),
        {.ulp = ulp}, {0x1p-126, numeric::infinity}, promised);
}

// Elements and depths with which no result overflows or underflows.
bool ordinary_projection(double b, double p22, double p32) {
    return moderate(1e-30, 1e30, b, p22, p32);
}

void append_depths(Entries& entries) {
    const Values depth = any_float().and_special().and_near({0x1p-126, 3.402823466e38});
    const Values component = either(uniform(-1, 1), any_float()).and_special().and_near({3.402823466e38});
    add(entries, "FINITE", &reference::gloam_is_finite, {depth});
    add(entries, "NAN", &reference::gloam_is_nan, {depth});
    add(entries, "FINITE-2", &reference::gloam_is_finite2, {vector(2, component)});
    add(entries, "FINITE-3", &reference::gloam_is_finite3, {vector(3, component)});
    add(entries, "FINITE-4", &reference::gloam_is_finite4, {vector(4, component)});
    add(entries, "BACKGROUND", &reference::gloam_is_background, {depth});
    add(entries, "BACKGROUND-depth", &reference::gloam_background_depth, {}, {},
        {numeric::infinity, numeric::infinity});
    const Values part = either(signed_log_uniform(1e-3, 1e3), signed_log_uniform(1e-30, 1e30));
    add(entries, "DEPTH-quotient", &reference::gloam_depth_quotient,
        {part.and_special(), part.and_special().and_near({0x1p126})}, {.ulp = 2.5},
        {0x1p-126, numeric::infinity},
        [](double a, double b) { return moderate(1e-30, 1e30, a) && !(std::abs(a / b) < 1e-37); });
    add_depth(entries, "DEPTH-perspective-vk", &reference::gloam_linear_depth_perspective_vk, perspective_vk,
              3, ordinary_projection);
    // True projections have an element of magnitude 1 or more. Smaller elements would cancel against the 1 of
    // OpenGL's range.
    add_depth(entries, "DEPTH-perspective-gl", &reference::gloam_linear_depth_perspective_gl, perspective_gl,
              3.5, [](double b, double p22, double p32) {
                  return ordinary_projection(b, p22, p32) && !(std::abs(p22) < 1.0);
              });
    add_depth(entries, "DEPTH-orthographic-vk", &reference::gloam_linear_depth_orthographic_vk,
              orthographic_vk, 3, ordinary_projection);
    add_depth(entries, "DEPTH-orthographic-gl", &reference::gloam_linear_depth_orthographic_gl,
              orthographic_gl, 4, [](double b, double p22, double p32) {
                  return ordinary_projection(b, p22, p32) && !(std::abs(p32) < 1.0);
              });
}

constexpr double huge = 3.5e38;

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

void append_coordinates(Entries& entries) {
    add(entries, "LENGTH", &reference::gloam_positive_length,
        {either(any_float(), uniform(-2, 2)).and_special()}, {}, {0, huge});
    const Values coordinate = either(integers(-16, 8192), integers(-2147483648L, 2147483647L));
    add(entries, "NDC-pixel", &reference::gloam_ndc_from_pixel,
        {vector(2, coordinate), vector(2, log_integers(4194304).and_near_integers({0, -2147483647L}))},
        {.ulp = 2.5}, {-1e10, 1e10}, [](glm::ivec2 pixel, glm::ivec2) {
            return std::abs(static_cast<double>(pixel.x)) <= 4194304 &&
                   std::abs(static_cast<double>(pixel.y)) <= 4194304;
        });
    add(entries, "UV-ndc", &reference::gloam_uv_from_ndc, {ndcs()}, {.ulp = 1}, {-huge, huge});
    const auto unproject = [&](const char* id, auto reference, double ulp) {
        add(entries, id, reference, {ndcs(), depths(), scales()}, {.ulp = ulp}, {-huge, huge},
            [](const auto&... inputs) { return moderate(smallest, largest, inputs...); });
    };
    unproject("POSITION-perspective", &reference::gloam_view_position_perspective, 3);
    unproject("POSITION-orthographic", &reference::gloam_view_position_orthographic, 2.5);
    const Values position =
        vector({signed_log_uniform(1e-3, 1e3), signed_log_uniform(1e-3, 1e3), signed_log_uniform(1e-3, 1e4)});
    const auto ndc = [&](const char* id, auto reference, double ulp) {
        add(entries, id, reference, {position.and_special(), scales()}, {.ulp = ulp}, {-huge, huge},
            [](const auto&... inputs) { return moderate(smallest, largest, inputs...); });
    };
    ndc("NDC-perspective", &reference::gloam_ndc_perspective, 3);
    ndc("NDC-orthographic", &reference::gloam_ndc_orthographic, 1);
    const Values radius = log_uniform(1e-3, 1e2).and_special();
    const auto in = [&](const char* id, auto reference, double ulp, const Domain& domain) {
        add(entries, id, reference, domain, {.ulp = ulp}, {0, huge},
            [](double radius, double depth, glm::dvec2 scale, const auto&...) {
                return moderate(smallest, largest, radius, depth, scale) && !std::isinf(radius);
            });
    };
    const Domain uv{radius, depths(), scales()};
    in("RADIUS-uv", &reference::gloam_projected_radius_uv, 3, uv);
    in("RADIUS-uv-orthographic", &reference::gloam_projected_radius_uv_orthographic, 1, uv);
}

// A position in front of the eye.
Values centers() {
    return vector({uniform(-5, 5), uniform(-5, 5), either(uniform(-20, -1), uniform(-2, -1))}).and_special();
}

// Offsets of neighbours from the centre: a step along the image and a change of depth, some beyond a
// silhouette.
Values steps(bool along_x) {
    const Values step = uniform(0.02, 0.2);
    const Values slack = uniform(-0.01, 0.01);
    const Values depth = either(uniform(-0.2, 0.2), uniform(-4, 0.9));
    return along_x ? vector({step, slack, depth}).and_special() : vector({slack, step, depth}).and_special();
}

// The neighbours are drawn as steps from the centre; left and down point the other way.
void place_neighbors(std::span<Word> words) {
    constexpr double signs[] = {-1.0, 1.0, 1.0, -1.0};
    for (std::size_t neighbor = 0; neighbor < 4; ++neighbor) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Word& word = words[3 * (neighbor + 1) + axis];
            const double step = from_word<double>(word) * (axis == 2 ? 1.0 : signs[neighbor]);
            word = to_word(from_word<double>(words[axis]) + step);
        }
    }
}

// The cross product is accurate if the directions are not nearly parallel, and its sign is if the surface is
// not seen edge-on.
template <class Viewer>
bool well_conditioned(glm::dvec3 x, glm::dvec3 y, Viewer viewer) {
    const glm::dvec3 product = glm::cross(x, y);
    const double sine = glm::length(product);
    if (!(sine > 0.0)) return true;
    return sine > 0.02 && std::abs(glm::dot(glm::normalize(product), glm::normalize(viewer))) > 1e-3;
}

template <bool orthographic>
bool promised_normal(glm::dvec3 center, glm::dvec3 left, glm::dvec3 right, glm::dvec3 up, glm::dvec3 down) {
    // Beyond these the sign of n . center depends on numbers that may be flushed to 0.
    if (!moderate(1e-30, 1e6, center) || !moderate(0, 1e6, left, right, up, down)) return false;
    const glm::dvec3 x = reference::gloam_neighbor_direction(center, left, right);
    const glm::dvec3 y = reference::gloam_neighbor_direction(center, down, up);
    return well_conditioned(x, y, orthographic ? glm::dvec3(0, 0, 1) : -center);
}

template <bool orthographic>
void add_neighbors(Entries& entries, const char* id, auto reference) {
    add(entries, id, reference,
        Domain{centers(), steps(true), steps(true), steps(false), steps(false)}.adjusted(place_neighbors),
        {.absolute = orthographic ? 4e-6 : 5e-7, .backward_ulp = 1}, {-1.000001, 1.000001},
        promised_normal<orthographic>);
}

void add_from_depth(Entries& entries, const char* id, auto reference, Budget budget, Codomain codomain) {
    add(
        entries, id,
        [reference](const ImageSet& images, glm::ivec2 pixel, const reference::GloamCamera& camera) {
            return reference(pixel, camera, fetch_of<double>(images, depth_prototype));
        },
        {either(image_pixel(), vector(2, integers(-2, 66))),
         vector({projection_scales(), image_size(), booleans()})},
        budget, codomain, nullptr, depth_scenarios(depth_prototype));
}

}  // namespace

void append_geometry(Entries& entries) {
    append_depths(entries);
    append_coordinates(entries);
    // Half of the lengths have squares in half precision, too.
    const Values any = either(vector_of_length(3, log_uniform(0.01, 200)),
                              either(vector_of_length(3, log_uniform(1e-37, 3e38)), vector(3, any_float())));
    add(entries, "NORMALIZE", &reference::gloam_safe_normalize,
        {any.and_special(), unit_vector(3).and_value(glm::vec3(0.0F))}, {.ulp = 5, .absolute = 1e-18},
        {-1.000001, 1.000001});
    add_neighbors<false>(entries, "NORMAL", &reference::gloam_normal_from_neighbors);
    add_neighbors<true>(entries, "NORMAL-orthographic", &reference::gloam_normal_from_neighbors_orthographic);
    const auto place = [](std::span<Word> words) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto center = from_word<double>(words[axis]);
            const double behind = from_word<double>(words[3 + axis]) * (axis == 2 ? 1.0 : -1.0);
            words[3 + axis] = to_word(center + behind);
            words[6 + axis] = to_word(center + from_word<double>(words[6 + axis]));
        }
    };
    add(entries, "NORMAL-direction", &reference::gloam_neighbor_direction,
        Domain{centers(), steps(true), steps(true)}.adjusted(place), {.ulp = 6, .backward_ulp = 1},
        {-1.000001, 1.000001}, [](const auto&... positions) { return moderate(1e-12, 1e12, positions...); });
    add(entries, "NORMAL-facing", &reference::gloam_facing_normal,
        {normals(), normals(), vector_of_length(3, log_uniform(1e-3, 1e3)).and_special()}, {.absolute = 3e-6},
        {-1.000001, 1.000001}, [](glm::dvec3 x, glm::dvec3 y, glm::dvec3 viewer) {
            return moderate(1e-10, 2.0, x, y) && moderate(1e-10, 1e10, viewer) &&
                   std::isfinite(viewer.x + viewer.y + viewer.z) && well_conditioned(x, y, viewer);
        });
    add_from_depth(entries, "POSITION-depth", &reference::gloam_camera_surface, {.ulp = 4}, {-1e6, 1e6});
    add_from_depth(entries, "NORMAL-depth", &reference::gloam_camera_normal, {.absolute = 1.8e-5},
                   {-1.000001, 1.000001});
}

}  // namespace gloam::catalogue
