// SPDX-License-Identifier: MIT
#include "scene/views/generators.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "numeric/random.hpp"
#include "scene/mesh_scene.hpp"

namespace gloam::scene::views {
namespace {

// A random value in [-1, 1] for whole coordinates.
double lattice_value(double x, double z, std::uint64_t seed) {
    const auto column = static_cast<std::uint64_t>(static_cast<std::int64_t>(x) + 4096);
    const auto row = static_cast<std::uint64_t>(static_cast<std::int64_t>(z) + 4096);
    std::uint64_t bits = seed + column * 0x9e3779b97f4a7c15U + row * 0xc2b2ae3d27d4eb4fU;
    bits = (bits ^ bits >> 29) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ bits >> 32) * 0x94d049bb133111ebU;
    return static_cast<double>(bits >> 11) * 0x1p-52 - 1.0;
}

double eased(double t) {
    return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

// A disc around the axis, as a fan of triangles.
Mesh make_end(const glm::dvec3& center, const glm::dvec3& axis, const glm::dvec3& across, double radius,
              int segments) {
    const glm::dvec3 other = glm::cross(axis, across);
    Mesh mesh;
    mesh.positions.emplace_back(center);
    for (int i = 0; i < segments; ++i) {
        const double angle = full_turn * i / segments;
        mesh.positions.emplace_back(center + radius * (std::cos(angle) * across + std::sin(angle) * other));
        const auto next = static_cast<std::uint32_t>(1 + (i + 1) % segments);
        mesh.indices.insert(mesh.indices.end(), {0, static_cast<std::uint32_t>(1 + i), next});
    }
    mesh.normals.assign(mesh.positions.size(), glm::vec3(axis));
    return mesh;
}

}  // namespace

Mesh turned(Mesh mesh, double radians, const glm::dvec3& translation) {
    const double c = std::cos(radians);
    const double s = std::sin(radians);
    const auto turn = [c, s](const glm::dvec3& v) {
        return glm::dvec3(c * v.x + s * v.z, v.y, c * v.z - s * v.x);
    };
    for (glm::vec3& p : mesh.positions) p = turn(p) + translation;
    for (glm::vec3& n : mesh.normals) n = turn(n);
    return mesh;
}

Mesh inside_out(Mesh mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    for (glm::vec3& normal : mesh.normals) normal = -normal;
    return mesh;
}

Mesh make_rod(const glm::dvec3& from, const glm::dvec3& to, double radius, int segments) {
    const glm::dvec3 axis = glm::normalize(to - from);
    const glm::dvec3 helper = std::abs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 across = glm::normalize(glm::cross(axis, helper));
    const glm::dvec3 other = glm::cross(across, axis);
    Mesh rod = make_cylinder({0, 0, 0}, radius, glm::distance(from, to), segments);
    const auto turn = [&](const glm::dvec3& v) { return v.x * across + v.y * axis + v.z * other; };
    for (glm::vec3& p : rod.positions) p = turn(p) + from;
    for (glm::vec3& n : rod.normals) n = turn(n);
    append(rod, make_end(from, -axis, across, radius, segments));
    append(rod, make_end(to, axis, across, radius, segments));
    return rod;
}

Mesh make_height_field(double half, int cells, const std::function<double(double x, double z)>& height) {
    Mesh mesh;
    const double step = 2.0 * half / cells;
    for (int row = 0; row <= cells; ++row) {
        for (int column = 0; column <= cells; ++column) {
            const double x = -half + column * step;
            const double z = -half + row * step;
            mesh.positions.emplace_back(x, height(x, z), z);
            const double dx = height(x + step, z) - height(x - step, z);
            const double dz = height(x, z + step) - height(x, z - step);
            mesh.normals.emplace_back(glm::normalize(glm::dvec3(-dx, 2.0 * step, -dz)));
        }
    }
    const auto stride = static_cast<std::uint32_t>(cells + 1);
    for (std::uint32_t row = 0; row + 1 < stride; ++row) {
        for (std::uint32_t column = 0; column + 1 < stride; ++column) {
            const std::uint32_t at = row * stride + column;
            mesh.indices.insert(mesh.indices.end(),
                                {at, at + stride, at + 1, at + 1, at + stride, at + stride + 1});
        }
    }
    return mesh;
}

double smooth_noise(double x, double z, std::uint64_t seed) {
    const double column = std::floor(x);
    const double row = std::floor(z);
    const double u = eased(x - column);
    const double v = eased(z - row);
    const double near = std::lerp(lattice_value(column, row, seed), lattice_value(column + 1, row, seed), u);
    const double far =
        std::lerp(lattice_value(column, row + 1, seed), lattice_value(column + 1, row + 1, seed), u);
    return std::lerp(near, far, v);
}

double fractal_noise(double x, double z, int octaves, std::uint64_t seed) {
    double sum = 0.0;
    double scale = 1.0;
    for (int i = 0; i < octaves; ++i, scale *= 2.0)
        sum += smooth_noise(scale * x, scale * z, seed + static_cast<std::uint64_t>(i)) / scale;
    return sum;
}

std::function<Camera(int)> path_of(const Stand& stand) {
    Camera start{.eye = stand.eye,
                 .target = stand.target,
                 .fovy_rad = stand.fovy_rad,
                 .near = stand.near,
                 .far = stand.far,
                 .reversed_z = true};
    if (stand.view_height > 0.0) {
        start.projection = Projection::orthographic;
        start.view_height = stand.view_height;
    }
    return [start, way = stand.way, step = stand.step](int frame) {
        Camera camera = start;
        if (way == Way::circling) {
            const double angle = frame * step.x * std::numbers::pi / 180.0;
            const glm::dvec3 back = start.eye - start.target;
            camera.eye =
                start.target + glm::dvec3(std::cos(angle) * back.x + std::sin(angle) * back.z, back.y,
                                          std::cos(angle) * back.z - std::sin(angle) * back.x);
            return camera;
        }
        camera.eye += static_cast<double>(frame) * step;
        if (way == Way::gliding) camera.target += static_cast<double>(frame) * step;
        return camera;
    };
}

Scene filmed(Scene scene, std::function<Camera(int)> path) {
    scene.camera = path(0);
    scene.camera_path = std::move(path);
    return scene;
}

Scene make_display(const std::filesystem::path& folder, const Display& display) {
    const std::filesystem::path file = folder / display.file;
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none))
        throw std::runtime_error(
            fmt::format("mesh {}: no such file; the package glmark2-data has it", file.string()));
    const Mesh mesh = standing(load_mesh(file), display.up, 1.0);
    Scene scene{.mesh = make_parallelogram({-40, 0, 40}, {80, 0, 0}, {0, 0, -80}, 1.0)};
    for (int row = 0; row < display.rows; ++row) {
        for (int copy = 0; copy < display.copies; ++copy) {
            const double x = display.spacing * (copy - 0.5 * (display.copies - 1));
            append(scene.mesh, turned(mesh, 0.9 * copy + 2.1 * row, {x, 0, -display.spacing * row}));
        }
    }
    scene.ao_radius = display.radius;
    return scene;
}

}  // namespace gloam::scene::views
