// SPDX-License-Identifier: MIT
// Reprojection, cameras, pixels, and how a surface bends and spreads.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <initializer_list>
#include <limits>

#include "catalogue/inputs.hpp"
#include "numeric/numbers.hpp"
#include "reference/geometry.hpp"
#include "reference/geometry_camera.hpp"

namespace gloam::catalogue {
namespace {

using namespace subject;

constexpr double huge = 3.5e38;

// The errors of matrix products are relative to their largest terms: the budgets hold for entries of
// ordinary size.
constexpr double smallest_entry = 1e-30;
constexpr double largest_entry = 1e2;

// Errors through a chain of matrices are promised for chains without scaling between the two projections, and
// for points for which no sum on the way has terms with a total magnitude above `farthest`. Larger terms
// cancel and lose digits.
constexpr double projection_scale = 2.0;
constexpr double rigid_tolerance = 1e-3;
constexpr double farthest = 200.0;

bool finite(const glm::dmat4& matrix) {
    bool all = true;
    subject::visit_scalars(matrix, [&](const auto& entry) { all = all && std::isfinite(entry); });
    return all;
}

// Whether the matrix is a rotation and a translation.
bool rigid(const glm::dmat4& matrix) {
    const glm::dmat3 turn(matrix);
    const glm::dmat3 identity = glm::transpose(turn) * turn - glm::dmat3(1.0);
    bool all = true;
    subject::visit_scalars(identity, [&](double entry) { all = all && std::abs(entry) <= rigid_tolerance; });
    const glm::dvec4 last = glm::row(matrix, 3);
    return all && last == glm::dvec4(0, 0, 0, 1);
}

bool scales_little(const glm::dmat4& projection) {
    bool all = true;
    const glm::dmat3 linear(projection);
    subject::visit_scalars(linear, [&](double entry) { all = all && std::abs(entry) <= projection_scale; });
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

// Of a point in clip space and the matrices to the previous one.
constexpr auto well_carried = [](const glm::dvec4& clip, const auto&... matrices) {
    return moderate(smallest_entry, largest_entry, clip, matrices...) &&
           carried_near(clip, {glm::dmat4(matrices)...}, true);
};

// World positions in a scene of usual size.
Values positions() {
    return vector(3, uniform(-100, 100)).and_special();
}

void append_reprojections(Entries& entries) {
    add(entries, "TSSAO-RP-uv", &reference::gloam_uv_from_clip,
        {either(clip_points(), vector(4, signed_log_uniform(1e-30, 1e30))).and_special()}, {.ulp = 3},
        {0, 1});
    add(entries, "TSSAO-RP", &reference::gloam_reproject_clip,
        {clip_points().and_special(), reprojection_matrices().and_special()},
        {.absolute = 1.2e-6, .backward_ulp = 4}, {0, 1},
        [](const glm::dvec4& clip, const glm::dmat4& matrix) {
            const double w = (matrix * clip).w;
            return moderate(smallest_entry, largest_entry, clip, matrix) && !(std::abs(w) < 0.05);
        });
    add(entries, "TSSAO-RP-static", &reference::gloam_previous_clip_static,
        {clip_points().and_special(), inverse_projection_matrices().and_special(),
         rigid_matrices(10).and_special(), rigid_matrices(10).and_special(),
         projection_matrices().and_special()},
        {.ulp = 4, .absolute = 4e-4, .of_largest_component = true}, {-huge, huge}, well_carried);
    add(entries, "TSSAO-RP-moving", &reference::gloam_previous_clip_moving,
        {clip_points().and_special(), inverse_projection_matrices().and_special(),
         rigid_matrices(10).and_special(), rigid_matrices(10).and_special(), rigid_matrices(10).and_special(),
         rigid_matrices(10).and_special(), projection_matrices().and_special()},
        {.ulp = 4, .absolute = 5e-4, .of_largest_component = true}, {-huge, huge}, well_carried);
    add(entries, "TSSAO-RP-world", &reference::gloam_previous_world,
        {positions(), rigid_matrices(10).and_special(), rigid_matrices(10).and_special()},
        {.ulp = 4, .absolute = 1.2e-4, .of_largest_component = true}, {-huge, huge},
        [](const glm::dvec3& world, const auto&... matrices) {
            return moderate(smallest_entry, largest_entry, world, matrices...) &&
                   carried_near(glm::dvec4(world, 1.0), {glm::dmat4(matrices)...}, false);
        });
    add(entries, "TSSAO-RP-depth", &reference::gloam_previous_depth,
        {positions(), rigid_matrices(10).and_special()}, {.absolute = 5e-5}, {-huge, huge},
        [](const auto&... values) { return moderate(smallest_entry, largest_entry, values...); });
    add(entries, "TSSAO-PREC", &reference::gloam_camera_centered_previous,
        {positions(), vector(3, signed_log_uniform(1e-6, 10)).and_special()}, {.ulp = 1}, {-huge, huge});
}

using Camera = reference::GloamCamera;

constexpr double smallest = 1e-12;
constexpr double largest = 1e12;

bool well_conditioned(glm::dvec2 at, glm::dvec3 point, glm::dvec3 normal, bool orthographic) {
    const glm::dvec3 start = orthographic ? glm::dvec3(at, 0.0) : glm::dvec3(0.0);
    const auto clear = [](glm::dvec3 a, glm::dvec3 b) {
        const glm::dvec3 products = glm::abs(a * b);
        return std::abs(glm::dot(a, b)) * 4.0 >= products.x + products.y + products.z;
    };
    return clear(normal, glm::dvec3(at, -1.0) - start) && clear(normal, point - start);
}

Values view_positions() {
    const Values coordinate = either(uniform(-1, 1), signed_log_uniform(1e-3, 1e3));
    return vector({coordinate, coordinate, uniform(1, 4)}).and_special();
}

Values depths() {
    return log_uniform(1e-3, 1e6).and_special();
}

void append_cameras(Entries& entries) {
    add(entries, "CAMERA-uv", &reference::gloam_camera_uv,
        Domain{view_positions(), cameras()}.adjusted(place_before_camera(0, 3)), {.ulp = 4, .absolute = 2e-7},
        {-huge, huge},
        [](glm::dvec3 at, const Camera& c) { return moderate(smallest, largest, at, c.p00_p11); });
    const Values pixel = vector(2, either(integers(-4, 64), integers(-4194304, 4194304)));
    add(entries, "CAMERA-position", &reference::gloam_camera_position, {pixel, depths(), cameras()},
        {.ulp = 3}, {-huge, huge},
        [](glm::ivec2, double d, const Camera& c) { return moderate(smallest, largest, d, c.p00_p11); });
    add(entries, "TSSAO-RP-view", &reference::gloam_previous_view,
        {vector(2, integers(-1, 1)), log_uniform(1e-3, 100), cameras(), rigid_matrices(10)},
        {.absolute = 1e-4}, {-huge, huge}, [](glm::ivec2, double d, const Camera& c, const glm::dmat4&) {
            return moderate(smallest, 100, d) && moderate(0.4, 4, c.p00_p11);
        });
    add(entries, "TSSAO-RP-motion", &reference::gloam_previous_moved,
        {vector(2, integers(-1, 2)), vector(2, uniform(-2, 2).and_near({1e9})).and_special(),
         view_positions(), cameras()},
        {.ulp = 4, .absolute = 4e-6}, {-huge, huge},
        [](glm::ivec2, glm::dvec2 m, glm::dvec3 at, const Camera& c) {
            return moderate(smallest, 100, m, at) && moderate(0.4, 4, c.p00_p11);
        });
    add(entries, "CAMERA-radius", &reference::gloam_camera_radius,
        {log_uniform(1e-3, 1e2).and_special(), depths(), cameras()}, {.ulp = 3}, {0, huge},
        [](double r, double d, const Camera& c) {
            return moderate(smallest, largest, r, d, c.p00_p11) && !(r > largest);
        });
    add(entries, "CAMERA-plane", &reference::gloam_plane_depth,
        {vector(2, uniform(-1, 1)), vector({uniform(-4, 4), uniform(-4, 4), uniform(-4, -1)}), unit_vector(3),
         booleans()},
        {.ulp = 14}, {0, std::numeric_limits<float>::max()}, well_conditioned);
}

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

void append_pixels(Entries& entries) {
    add(entries, "TSSAO-7-index", &reference::gloam_nearest_index,
        {uniform(-0.2, 1.2).and_near({0.5, 1.0}).and_special(),
         log_integers(16384).and_near_integers({0, -2147483647L})},
        {.backward_ulp = 1});
    add(entries, "TSSAO-7-pixel", &reference::gloam_nearest_pixel,
        Domain{uvs(), sizes()}.adjusted(place_at_borders), {.backward_ulp = 1});
    add(entries, "TSSAO-7", &reference::gloam_pixel_center, Domain{uvs(), sizes()}.adjusted(place_at_borders),
        {.ulp = 2.5, .backward_ulp = 1}, {0, 1});
    add(entries, "INSIDE", &reference::gloam_inside_unit,
        {vector(2, uniform(-0.2, 1.2).and_near({0.0, 1.0})).and_special()});
    const Values pixel = vector(2, integers(-100, 5000).and_near_integers({0, 2147483647, -2147483647L}));
    add(entries, "TSSAO-BORDER", &reference::gloam_clamp_to_edge, {pixel, sizes()});
    const Values guard =
        either(uniform(0, 1), uniform(0.05, 0.1)).and_near({0.05, 0.1, 0.25, 0.5}).and_special();
    const Domain domain{sizes(), guard};
    add(entries, "TSSAO-BORDER-width", &reference::gloam_guard_band_border, domain, {.backward_ulp = 1},
        {0, 4194305});
    add(entries, "TSSAO-BORDER-guard", &reference::gloam_guard_band_guard, domain,
        {.ulp = 5, .backward_ulp = 1}, {0, 1});
    add(entries, "TSSAO-BORDER-tan", &reference::gloam_guard_band_tan_half_fov,
        {log_uniform(0.05, 10).and_special(), uniform(0, 1).and_special()}, {.ulp = 3}, {-huge, huge},
        [](double tangent, double guard) {
            return moderate(1e-30, huge, tangent) && guard >= 0 && guard <= 1;
        });
}

using Moments = reference::GloamSurfaceMoments;

bool usual_moments(const Moments& m) {
    return moderate(1e-9, 1e4, m.weight, m.mean, m.variance, m.covariance);
}

// Weight, mean, variances, covariances.
Values moments() {
    std::vector<Values> members{either(uniform(0.25, 64), constant(0.0F))};
    members.insert(members.end(), 3, uniform(-5, 5));
    members.insert(members.end(), 3, uniform(0, 2));
    members.insert(members.end(), 3, uniform(-1, 1));
    return vector(members).only_as_drawn();
}

}  // namespace

void append_geometry_camera(Entries& entries) {
    append_reprojections(entries);
    append_cameras(entries);
    append_pixels(entries);
    // Most steps are long enough for half precision, too, which has no product of four of 0.02.
    const Values usual = vector_of_length(3, uniform(0.1, 0.2));
    const Values step = either(usual, either(usual, vector_of_length(3, log_uniform(1e-12, 1e12))))
                            .and_value(glm::vec3(0))
                            .and_special();
    const Values turn = offsets_of(uniform(0, 0.01), uniform(0.8, 1));
    add(entries, "CS-K-principal", &reference::gloam_principal_curvatures, {step, step, turn, turn},
        {.absolute = 1.1e-5}, {-numeric::largest_float, numeric::largest_float},
        [](glm::dvec3 px, glm::dvec3 py, glm::dvec3 nx, glm::dvec3 ny) {
            const double a = glm::length(px);
            const double b = glm::length(py);
            return a > 0.09 && a < 0.21 && b > 0.09 && b < 0.21 && glm::length(nx) < 1.1 &&
                   glm::length(ny) < 1.1 && glm::length(glm::cross(px, py)) > 0.8 * a * b;
        });
    add(entries, "MOMENTS-empty", &reference::gloam_moments_empty, {}, {}, {0, 0});
    add(entries, "MOMENTS-of", &reference::gloam_moments_of, {vector(3, uniform(-5, 5)).only_as_drawn()}, {},
        {-5, 5});
    add(entries, "MOMENTS-add", &reference::gloam_moments_add, {moments(), moments()}, {.absolute = 2e-5},
        {-128, 128}, [](const Moments& a, const Moments& b) { return usual_moments(a) && usual_moments(b); });
    add(entries, "MOMENTS-along", &reference::gloam_moments_along, {moments(), normals()}, {.absolute = 2e-6},
        {0, numeric::infinity},
        [](const Moments& m, const glm::dvec3& n) { return usual_moments(m) && moderate(1e-9, 1.1, n); });
    const Values any = offsets_of(log_uniform(1e-3, 10), log_uniform(1e-37, 1e38));
    add(entries, "LENGTH-vector", &reference::gloam_length, {any}, {.ulp = 4}, {0, numeric::infinity},
        [](glm::dvec3 v) { return small(v, 1e38) && glm::length(v) >= 1e-30; });
    const Values radius = either(log_uniform(1, 4096), log_uniform(1e-37, 1e38)).and_special();
    add(entries, "CS-G-cap", &reference::gloam_radius_cap, Domain{vector(2, radius), radius}, {.ulp = 3.5},
        {0, 3.5e38}, [](glm::dvec2 axes, double cap) {
            return moderate(1e-18, 1e18, axes, cap) && std::max(axes.x, axes.y) < 1e18;
        });
}

}  // namespace gloam::catalogue
