// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <numbers>

#include "scene/mesh.hpp"

// Shapes of the views' generators, beside those of scene/primitives.hpp.
namespace gloam::scene::views {

inline constexpr double full_turn = 2.0 * std::numbers::pi;  // radians

// The mesh rotated about the vertical axis through the origin by `radians`, then moved.
[[nodiscard]] Mesh turned(Mesh mesh, double radians, const glm::dvec3& translation);

// The mesh seen from inside: triangles and normals reversed.
[[nodiscard]] Mesh inside_out(Mesh mesh);

// A straight rod between two different points, with smooth sides and flat ends. segments: around, at least 3.
[[nodiscard]] Mesh make_rod(const glm::dvec3& from, const glm::dvec3& to, double radius, int segments);

// A square height field: y = height(x, z) over x and z from -half to half, with cells x cells cells, smooth
// normals.
[[nodiscard]] Mesh make_height_field(double half, int cells,
                                     const std::function<double(double x, double z)>& height);

// Smooth noise in [-1, 1] with the features of size 1, from random values at whole coordinates.
[[nodiscard]] double smooth_noise(double x, double z, std::uint64_t seed);

// Sum of `octaves` smooth noises, each of half the size and half the height of the one before.
[[nodiscard]] double fractal_noise(double x, double z, int octaves, std::uint64_t seed);

}  // namespace gloam::scene::views
