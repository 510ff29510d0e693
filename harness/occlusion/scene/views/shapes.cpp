// SPDX-License-Identifier: MIT
#include <cmath>
#include <stdexcept>
#include <string>

#include "scene/views/generators.hpp"

namespace gloam::scene::views {
namespace {

// A tube around a trefoil knot, upright on the ground; smooth normals outwards.
Mesh make_knot(double scale) {
    constexpr int along = 240;
    constexpr int around = 32;
    constexpr double radius = 0.55;
    const auto curve = [](double part) -> glm::dvec3 {
        const double t = full_turn * part;
        return {std::sin(t) + 2.0 * std::sin(2.0 * t), std::cos(t) - 2.0 * std::cos(2.0 * t),
                -std::sin(3.0 * t)};
    };
    Mesh knot = make_grid(around, along, [&](int x, int y) -> Vertex {
        const double t = static_cast<double>(y % along) / along;
        constexpr double step = 1e-4;
        const glm::dvec3 forward = glm::normalize(curve(t + step) - curve(t - step));
        const glm::dvec3 side = glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1)));
        const double angle = full_turn * (x % around) / around;
        const glm::dvec3 out = std::cos(angle) * side + std::sin(angle) * glm::cross(forward, side);
        return {curve(t) + radius * out, out};
    });
    const double low = bounds_of(knot).low.y;
    return placed(std::move(knot), glm::dmat3(1), {0, -scale * low, 0}, scale);
}

// Adds the shapes of a row, see shapes_of().
struct Shapes {
    Parts parts;
    numeric::Random random;

    void add_all(const Row& list, std::size_t first, const glm::dvec3& moved) {
        for (std::size_t i = first; i < list.size(); ++i) add(list[i], moved);
    }

    void add(const Row& shape, const glm::dvec3& moved) {
        const std::string name = shape[0];
        const auto number = [&](std::size_t place) { return shape.at(place).get<double>(); };
        const auto count = [&](std::size_t place) { return shape.at(place).get<int>(); };
        const auto point = [&](std::size_t place) { return moved + vector_of(shape, place); };
        if (name == "cell") {
            parts.cell = number(1);
        } else if (name == "box") {
            parts.box(point(1), point(4));
        } else if (name == "inside") {
            parts.add(inside_out(make_box(point(1), point(4), parts.cell)));
        } else if (name == "plane") {
            const Mesh plane =
                make_parallelogram(point(1), vector_of(shape, 4), vector_of(shape, 7), parts.cell);
            parts.add(shape.size() > 10 ? colored(plane, vector_of(shape, 10)) : plane);
        } else if (name == "sphere") {
            parts.add(make_sphere(point(1), number(4), count(5)));
        } else if (name == "cylinder") {
            parts.add(make_cylinder(point(1), number(4), number(5), count(6)));
        } else if (name == "knot") {
            parts.add(make_knot(number(1)));
        } else if (name == "books") {
            add_books(parts, random, {{0.015, 0.16, 0.13}, {0.05, 0.27, 0.2}, 0.001, 0.87}, point(1),
                      number(4));
        } else if (name == "all of") {
            parts.add(shapes_of(*std::ranges::find(
                rows(), shape[1], [](const Row& row) -> const Row& { return row["name"]; })));
        } else {
            for (int i = 0; i < count(1); ++i) {
                const double angle = full_turn * i / count(1);
                add_all(
                    shape, 3,
                    moved + (name == "each" ? static_cast<double>(i) * vector_of(shape[2])
                                            : number(2) * glm::dvec3(0, std::cos(angle), std::sin(angle))));
            }
        }
    }
};

}  // namespace

void add_books(Parts& parts, numeric::Random& random, const Books& books, const glm::dvec3& first,
               double end) {
    for (glm::dvec3 at = first; at.x < end;) {
        glm::dvec3 size;
        for (const int axis : {0, 1, 2}) size[axis] = random.uniform(books.least[axis], books.most[axis]);
        if (random.unit() < books.share) parts.box(at, at + size);
        at.x += size.x + books.gap;
    }
}

Mesh shapes_of(const Row& row) {
    Shapes shapes{{}, random_of(row)};
    shapes.add_all(row["shapes"], 0, {0, 0, 0});
    return std::move(shapes.parts.mesh);
}

}  // namespace gloam::scene::views
