// SPDX-License-Identifier: MIT
#include "scene/analytic_scene.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "scene/draw.hpp"

namespace gloam::scene {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double quarter = 0.25 * pi;

// Integral of (1 - c / cos t)^2 over t from -arccos(c) to `end`, for a wall at c = a / R; 0 beyond the
// radius.
double wall_integral(double c, double end) {
    if (c >= 1.0) return 0.0;
    const auto antiderivative = [c](double t) {
        const double tangent = std::tan(t);
        return t - 2.0 * c * std::asinh(tangent) + c * c * tangent;
    };
    const double reach = std::acos(c);
    return antiderivative(std::clamp(end, -reach, reach)) - antiderivative(-reach);
}

constexpr double far = 64.0;  // half a side of a plane

// A rectangle around the y axis: from `from` to `to`, 2 far wide.
Mesh strip(const glm::dvec3& from, const glm::dvec3& to) {
    return make_parallelogram(from - glm::dvec3(0, far, 0), to - from, {0, 2.0 * far, 0}, far);
}

Mesh floor() {
    return strip({-far, 0, 0}, {far, 0, 0});
}

Mesh wall(double x, double height = far) {
    return strip({x, 0, height}, {x, 0, 0});
}

// A plane that rises by 45 degrees from the point towards x, or away from it.
Mesh slope(double side) {
    return side > 0.0 ? strip({0, 0, 0}, {far, 0, far}) : strip({-far, 0, far}, {0, 0, 0});
}

// A half of a level plane above, on the side of the blockers from x on; seen from above.
Mesh roof(double height, double x) {
    return strip({x, 0, height}, {far, 0, height});
}

// A surface of revolution around the point's normal, finer towards the point. profile: its vertex in the
// plane of x and z at a part of its length, which begins at the point.
Mesh bowl(Vertex (*profile)(double part)) {
    constexpr int segments = 512;
    constexpr int rings = 256;
    return make_grid(segments, rings, [&](int column, int row) -> Vertex {
        const double part = static_cast<double>(row) / rings;
        const auto [at, normal] = profile(part * part);
        const double around = -2.0 * pi * column / segments;
        const auto turned = [&](const glm::dvec3& v) {
            return glm::dvec3(v.x * std::cos(around), v.x * std::sin(around), v.z);
        };
        return {turned(at), turned(normal)};
    });
}

// A funnel that rises by 45 degrees from the point all round, and the inside of a sphere of radius R.
Mesh funnel() {
    return bowl([](double part) -> Vertex {
        return {far * part * glm::dvec3(1, 0, 1), std::sqrt(0.5) * glm::dvec3(-1, 0, 1)};
    });
}

Mesh sphere() {
    return bowl([](double part) -> Vertex {
        const glm::dvec3 inwards{-std::sin(pi * part), 0, std::cos(pi * part)};
        return {glm::dvec3(0, 0, 1) - inwards, inwards};
    });
}

// A camera that looks at the point. tilt: radians from the normal to the eye's direction, away from the
// blockers. half_height: of the image, at the point's depth.
Camera looking(Projection projection, double tilt, double distance = 4.0, double half_height = 1.6) {
    constexpr double roll = 0.35;  // radians about the optical axis: no edge runs along the pixels
    const glm::dvec3 back{-std::sin(tilt), 0, std::cos(tilt)};
    const glm::dvec3 side{std::cos(tilt), 0, std::sin(tilt)};
    return {.eye = distance * back,
            .target = {0, 0, 0},
            .up = glm::cross(back, std::cos(roll) * side + std::sin(roll) * glm::dvec3(0, 1, 0)),
            .projection = projection,
            .fovy_rad = 2.0 * std::atan(half_height / distance),
            .view_height = 2.0 * half_height,
            .near = 1e-4,  // the rim of the sphere begins at the eye
            .far = 4.0 * far};
}

}  // namespace

std::vector<ClosedFormView> closed_form_views(Projection projection) {
    const bool orthographic = projection == Projection::orthographic;
    const auto tilted = [&](double tilt) { return looking(projection, tilt); };
    std::vector<ClosedFormView> all;
    const auto add = [&](std::string name, const std::vector<Mesh>& parts, const Camera& camera,
                         double occlusion) {
        Scene scene{.name = std::move(name), .camera = camera};
        for (const Mesh& part : parts) append(scene.mesh, part);
        all.push_back({std::move(scene), occlusion});
    };
    for (const double degrees : {0.0, 30.0, 60.0})
        add(fmt::format("plane {:g}", degrees), {floor()}, tilted(degrees * pi / 180.0), 0.0);
    for (const double x : {0.25, 0.5, 0.75})
        add(fmt::format("wall {:g}", x), {floor(), wall(x)}, tilted(quarter), corner_occlusion(x, 1.0, 1.0));
    // A floor under a ceiling at 0.5 R, seen from between them, 2 R away, where the floor is seen at an angle
    // of 7 degrees.
    const double between = std::hypot(2.0, 0.25);
    if (!orthographic)
        add("ceiling", {floor(), inside_out(roof(0.5, -far))},
            looking(projection, std::atan2(2.0, 0.25), between, between), 0.25);
    // A floor that rises by 45 degrees from the line through the point; a line between two such slopes; a
    // funnel; the inside of a sphere of radius R, whose orthographic view starts at half the height: the
    // upper half would hide the inside.
    const double groove = 0.5 * (1.0 - std::cos(quarter));
    add("groove", {floor(), slope(1.0)}, tilted(0.0), groove);
    add("valley", {slope(1.0), slope(-1.0)}, tilted(0.0), 2.0 * groove);
    add("pit", {funnel()}, tilted(0.0), 0.5);
    add("sphere", {sphere()}, looking(projection, 0.0, orthographic ? 1.0 : 1.9), 1.0 / 12.0);
    // A floor 0.5 R before a block 1.5 R high, seen from straight above; a floor under the edge of a plate
    // without thickness at 0.5 R.
    add("step", {floor(), wall(0.5, 1.5), roof(1.5, 0.5)}, tilted(0.0), corner_occlusion(0.5, 1.0, 1.0));
    add("plate", {floor(), roof(0.5, 0.0)}, tilted(pi / 6.0), 0.125);
    return all;
}

GBuffer draw(const ClosedFormView& view, std::uint32_t size) {
    GBuffer buffer = draw(view.scene, {size, size});
    buffer.border = backend::Extent{size / 2, size / 2};
    // Several surfaces meet in the middle.
    buffer.normal[std::size_t{size} * (size / 2) + size / 2] = view_rotation(view.scene.camera)[2];
    return buffer;
}

double corner_occlusion(double a, double b, double radius) {
    // The azimuth of the corner's edge, where the nearer wall changes; measured from the first wall's normal.
    const double edge = std::atan2(b, a);
    return (wall_integral(a / radius, edge) + wall_integral(b / radius, 0.5 * pi - edge)) / (2.0 * pi);
}

double corner_occlusion_at(const glm::dvec3& world, double radius) {
    std::array distances{std::abs(world.x), std::abs(world.y), std::abs(world.z)};
    std::ranges::sort(distances);
    return corner_occlusion(distances[1], distances[2], radius);
}

}  // namespace gloam::scene
