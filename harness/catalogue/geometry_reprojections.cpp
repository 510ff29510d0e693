// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <initializer_list>

#include "catalogue/geometry_parts.hpp"
#include "catalogue/inputs.hpp"
#include "reference/geometry.hpp"

namespace gloam::catalogue {
namespace {

using namespace check;

constexpr double huge = 3.5e38;
constexpr const char* file = "gloam/geometry/reprojection.glsl";
constexpr const char* source = "TSSAO (Mattausch et al.), reprojection";

using StaticSignature = glm::vec4(glm::vec4, glm::mat4, glm::mat4, glm::mat4, glm::mat4);
using MovingSignature = glm::vec4(glm::vec4, glm::mat4, glm::mat4, glm::mat4, glm::mat4, glm::mat4,
                                  glm::mat4);

// The errors of matrix products are relative to their largest terms: the budgets hold for entries of ordinary
// size.
constexpr double smallest = 1e-30;
constexpr double largest = 1e2;

// Errors through a chain of matrices are promised for chains without scaling between the two projections, and
// for points for which no sum on the way has terms with a total magnitude above `farthest`. Larger terms
// cancel and lose digits.
constexpr double projection_scale = 2.0;
constexpr double rigid_tolerance = 1e-3;
constexpr double farthest = 200.0;

bool finite(const glm::dmat4& matrix) {
    bool all = true;
    check::visit_scalars(matrix, [&](const auto& entry) { all = all && std::isfinite(entry); });
    return all;
}

// Whether the matrix is a rotation and a translation.
bool rigid(const glm::dmat4& matrix) {
    const glm::dmat3 turn(matrix);
    const glm::dmat3 identity = glm::transpose(turn) * turn - glm::dmat3(1.0);
    bool all = true;
    check::visit_scalars(identity, [&](double entry) { all = all && std::abs(entry) <= rigid_tolerance; });
    const glm::dvec4 last = glm::row(matrix, 3);
    return all && last == glm::dvec4(0, 0, 0, 1);
}

bool scales_little(const glm::dmat4& projection) {
    bool all = true;
    const glm::dmat3 linear(projection);
    check::visit_scalars(linear, [&](double entry) { all = all && std::abs(entry) <= projection_scale; });
    return all;
}

// Multiplies the point by the matrix. Returns whether it did so without large sums.
bool carry(glm::dvec4& point, const glm::dmat4& matrix) {
    glm::dvec4 sums(0.0);
    for (int column = 0; column < 4; ++column) sums += glm::abs(matrix[column] * point[column]);
    point = matrix * point;
    return std::max({sums.x, sums.y, sums.z, sums.w}) <= farthest;
}

// Inputs that are not finite are always judged.
bool carried_near(glm::dvec4 point, std::initializer_list<glm::dmat4> chain, bool projections) {
    if (!(std::ranges::all_of(chain, finite) && std::isfinite(glm::dot(point, point)))) return true;
    for (const glm::dmat4& matrix : chain) {
        const bool end = projections && (&matrix == chain.begin() || &matrix == chain.end() - 1);
        if (!(end ? scales_little(matrix) : rigid(matrix)) || !carry(point, matrix)) return false;
    }
    return true;
}

void append_uv(Entries& entries) {
    entries.push_back(equation<bool(glm::vec4, Out<glm::vec2>)>(
        {.id = "TSSAO-RP-uv",
         .function = "gloam_uv_from_clip",
         .file = file,
         .title = "texture coordinates of a clip-space point",
         .formula = "xy / (2 w) + 1/2, inside where |x|, |y| <= w",
         .source = source},
        &reference::gloam_uv_from_clip,
        {.domain = {either(clip_points(), vector(4, signed_log_uniform(1e-30, 1e30))).and_special()},
         .budget = {.ulp = 3},
         .codomain = {0, 1}}));
    entries.push_back(equation<bool(glm::vec4, glm::mat4, Out<glm::vec2>)>(
        {.id = "TSSAO-RP",
         .function = "gloam_reproject_clip",
         .file = file,
         .title = "previous texture coordinates, static scene",
         .formula = "t' = P' V' V^-1 P^-1 t",
         .source = source},
        &reference::gloam_reproject_clip,
        {.domain = {clip_points().and_special(), reprojection_matrices().and_special()},
         .budget = {.absolute = 1.2e-6, .backward_ulp = 4},
         .codomain = {0, 1},
         .promised = make_predicate<bool(glm::vec4, glm::mat4, Out<glm::vec2>)>(
             [](const glm::dvec4& clip, const glm::dmat4& matrix) {
                 const double w = (matrix * clip).w;
                 return moderate(smallest, largest, clip, matrix) && !(std::abs(w) < 0.05);
             })}));
}

void append_clip(Entries& entries) {
    entries.push_back(equation<StaticSignature>(
        {.id = "TSSAO-RP-static",
         .function = "gloam_previous_clip_static",
         .file = file,
         .title = "previous clip-space point of a static surface point",
         .formula = "P' V' V^-1 P^-1 t",
         .source = source},
        &reference::gloam_previous_clip_static,
        {.domain = {clip_points().and_special(), inverse_projection_matrices().and_special(),
                    rigid_matrices(10).and_special(), rigid_matrices(10).and_special(),
                    projection_matrices().and_special()},
         .budget = {.ulp = 4, .absolute = 4e-4, .of_largest_component = true},
         .codomain = {-huge, huge},
         .promised = make_predicate<StaticSignature>([](const glm::dvec4& clip, const auto&... matrices) {
             return moderate(smallest, largest, clip, matrices...) &&
                    carried_near(clip, {glm::dmat4(matrices)...}, true);
         })}));
    entries.push_back(equation<MovingSignature>(
        {.id = "TSSAO-RP-moving",
         .function = "gloam_previous_clip_moving",
         .file = file,
         .title = "previous clip-space point of a point of a moving object",
         .formula = "P' V' M' M^-1 V^-1 P^-1 t",
         .source = source},
        &reference::gloam_previous_clip_moving,
        {.domain = {clip_points().and_special(), inverse_projection_matrices().and_special(),
                    rigid_matrices(10).and_special(), rigid_matrices(10).and_special(),
                    rigid_matrices(10).and_special(), rigid_matrices(10).and_special(),
                    projection_matrices().and_special()},
         .budget = {.ulp = 4, .absolute = 5e-4, .of_largest_component = true},
         .codomain = {-huge, huge},
         .promised = make_predicate<MovingSignature>([](const glm::dvec4& clip, const auto&... matrices) {
             return moderate(smallest, largest, clip, matrices...) &&
                    carried_near(clip, {glm::dmat4(matrices)...}, true);
         })}));
}

// World positions in a scene of usual size.
Values positions() {
    return vector(3, uniform(-100, 100)).and_special();
}

void append_previous(Entries& entries) {
    entries.push_back(equation<glm::vec3(glm::vec3, glm::mat4, glm::mat4)>(
        {.id = "TSSAO-RP-world",
         .function = "gloam_previous_world",
         .file = file,
         .title = "previous world position of a point of a moving object",
         .formula = "M' M^-1 x",
         .source = source},
        &reference::gloam_previous_world,
        {.domain = {positions(), rigid_matrices(10).and_special(), rigid_matrices(10).and_special()},
         .budget = {.ulp = 4, .absolute = 2.4e-4, .of_largest_component = true},
         .codomain = {-huge, huge},
         .promised = make_predicate<glm::vec3(glm::vec3, glm::mat4, glm::mat4)>(
             [](const glm::dvec3& world, const auto&... matrices) {
                 return moderate(smallest, largest, world, matrices...) &&
                        carried_near(glm::dvec4(world, 1.0), {glm::dmat4(matrices)...}, false);
             })}));
    entries.push_back(equation<float(glm::vec3, glm::mat4)>(
        {.id = "TSSAO-RP-depth",
         .function = "gloam_previous_depth",
         .file = file,
         .title = "depth of a point in the previous camera",
         .formula = "d' = -(V' x').z",
         .source = source},
        &reference::gloam_previous_depth,
        {.domain = {positions(), rigid_matrices(10).and_special()},
         .budget = {.absolute = 5e-5},
         .codomain = {-huge, huge},
         .promised = make_predicate<float(glm::vec3, glm::mat4)>(
             [](const auto&... values) { return moderate(smallest, largest, values...); })}));
}

}  // namespace

void append_reprojections(Entries& entries) {
    append_uv(entries);
    append_clip(entries);
    append_previous(entries);
    entries.push_back(equation<glm::vec3(glm::vec3, glm::vec3)>(
        {.id = "TSSAO-PREC",
         .function = "gloam_camera_centered_previous",
         .file = "gloam/geometry/camera_centered.glsl",
         .title = "position relative to the previous eye",
         .formula = "q' = q + (eye - eye')",
         .source = "TSSAO (Mattausch et al.), precision of positions"},
        &reference::gloam_camera_centered_previous,
        {.domain = {positions(), vector(3, signed_log_uniform(1e-6, 10)).and_special()},
         .budget = {.ulp = 1},
         .codomain = {-huge, huge}}));
}

}  // namespace gloam::catalogue
