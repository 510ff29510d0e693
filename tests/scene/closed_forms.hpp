// SPDX-License-Identifier: MIT
#pragma once

#include "scene/mesh.hpp"
#include "scene/occlusion_tracer.hpp"
#include "support/test.hpp"

// Meshes whose occlusion is known, at the points where it is: what the ray tracer is checked against.
namespace gloam::scene::test {

struct KnownPoint {
    Receiver receiver;
    double occlusion = 0.0;
};

struct KnownScene {
    std::string name;
    Mesh mesh;
    double radius = 1.0;
    Falloff falloff = Falloff::linear;
    std::vector<KnownPoint> points;
    Weighting weighting = Weighting::cosine;
};

constexpr double everywhere = std::numeric_limits<double>::infinity();
constexpr double far_away = 1e4;  // where what should be infinite ends

// A point on the ground y = 0.
inline Receiver on_ground(double x, double z) {
    return {.position = {x, 0, z}, .normal = {0, 1, 0}, .facet = {0, 1, 0}, .clearance = 1e-7};
}

inline Mesh ground(double extent) {
    return make_parallelogram({-extent, 0, -extent}, {0, 0, 2 * extent}, {2 * extent, 0, 0}, 2 * extent);
}

inline KnownScene open_plane() {
    KnownScene scene{.name = "plane", .mesh = ground(100.0)};
    for (int i = 0; i < 20; ++i) scene.points.push_back({on_ground(0.37 * i, -0.21 * i), 0.0});
    return scene;
}

inline double ceiling_occlusion(Falloff falloff, double q) {
    if (falloff == Falloff::step) return 1.0 - q * q;
    if (falloff == Falloff::linear) return (1.0 - q) * (1.0 - q);
    return 1.0 - q * q + 2.0 * q * q * std::log(q);
}

// An infinite ceiling; heights of 0.1 to 0.9 of the radius.
inline KnownScene ceiling(Falloff falloff, double q) {
    KnownScene scene{.name = std::string("ceiling, ") + name_of(falloff), .radius = 2.0, .falloff = falloff};
    scene.mesh = ground(30.0);
    append(scene.mesh, make_parallelogram({-30, q * 2.0, -30}, {60, 0, 0}, {0, 0, 60}, 60.0));
    for (int i = 0; i < 40; ++i)
        scene.points.push_back({on_ground(0.13 * i, 0.07 * i), ceiling_occlusion(falloff, q)});
    return scene;
}

// All directions alike: the mean of 1 - q / z over the heights z of directions from q to 1.
inline KnownScene ceiling_seen_uniformly(double q) {
    KnownScene scene = ceiling(Falloff::linear, q);
    scene.name += ", uniform";
    scene.weighting = Weighting::uniform;
    for (KnownPoint& point : scene.points) point.occlusion = 1.0 - q + q * std::log(q);
    return scene;
}

inline double wall_occlusion(Falloff falloff, double c) {
    if (c >= 1.0) return 0.0;
    const double s = std::sqrt(1.0 - c * c);
    const double angle = std::acos(c);
    const double step = angle - c * s;
    if (falloff == Falloff::step) return step / std::numbers::pi;
    if (falloff == Falloff::linear)
        return 2.0 / std::numbers::pi * (0.5 * step - c * (std::acosh(1.0 / c) - s));
    return 2.0 / std::numbers::pi * ((0.5 + c * c) * angle - 1.5 * c * s);
}

// An infinite wall; points at 0.02 to 1.1 radii from it.
inline KnownScene wall(Falloff falloff) {
    KnownScene scene{.name = std::string("wall, ") + name_of(falloff), .radius = 1.5, .falloff = falloff};
    scene.mesh = ground(30.0);
    append(scene.mesh, make_parallelogram({0, 0, -30}, {0, 30, 0}, {0, 0, 60}, 60.0));
    for (int i = 0; i < 55; ++i) {
        const double c = 0.02 * (i + 1);
        scene.points.push_back({on_ground(1.5 * c, 0.05 * i), wall_occlusion(falloff, c)});
    }
    return scene;
}

// A long wall of height 1, no falloff.
inline KnownScene low_wall() {
    KnownScene scene{.name = "wall of finite height", .radius = everywhere, .falloff = Falloff::step};
    scene.mesh = make_parallelogram({0, 0, -far_away}, {0, 1, 0}, {0, 0, 2 * far_away}, 2 * far_away);
    for (int i = 1; i <= 40; ++i) {
        const double a = 0.1 * i;
        scene.points.push_back({on_ground(a, 0.3), 0.5 * (1.0 - 1.0 / std::sqrt(1.0 + 1.0 / (a * a)))});
    }
    return scene;
}

// A point within a closed sphere, on its wall.
inline KnownScene enclosed(Falloff falloff, double diameter_over_radius) {
    const double x = diameter_over_radius;
    double occlusion = x <= 1.0 ? 1.0 : 1.0 / (x * x);
    if (falloff == Falloff::linear) occlusion = x <= 1.0 ? 1.0 - 2.0 * x / 3.0 : 1.0 / (3.0 * x * x);
    if (falloff == Falloff::quadratic) occlusion = x <= 1.0 ? 1.0 - 0.5 * x * x : 0.5 / (x * x);
    KnownScene scene{.name = std::string("in a sphere, ") + name_of(falloff), .falloff = falloff};
    scene.mesh = make_sphere({0, 0, 0}, 0.5 * x, 256, 512);
    for (int i = 0; i < 40; ++i) {
        const double angle = 0.1 + 0.15 * i;
        const glm::dvec3 inwards{std::cos(angle) * 0.6, 0.8, std::sin(angle) * 0.6};
        // A little within, for the mesh is inscribed in the sphere.
        scene.points.push_back(
            {{.position = -0.5 * x * 0.99994 * inwards, .normal = inwards, .facet = inwards}, occlusion});
    }
    return scene;
}

// A sphere over a plane: radius 0.5, centre 1.2 high, no falloff; only where all of it is above the horizon.
inline KnownScene sphere_over_plane() {
    KnownScene scene{.name = "sphere over plane", .radius = everywhere, .falloff = Falloff::step};
    scene.mesh = ground(50.0);
    append(scene.mesh, make_sphere({0, 1.2, 0}, 0.5, 256, 512));
    for (int i = 0; i < 50; ++i) {
        const double x = 0.05 * i;
        const double distance = std::hypot(x, 1.2);
        const double part = 0.5 / distance;
        scene.points.push_back({on_ground(x, 0.0), part * part * 1.2 / distance});
    }
    return scene;
}

// A plane that rises at the angle from the line x = 0, and one on the other side too when `both`.
inline KnownScene groove(double angle, bool both) {
    KnownScene scene{
        .name = both ? "groove" : "groove, one side", .radius = everywhere, .falloff = Falloff::step};
    const glm::dvec3 along{0, 0, 2 * far_away};
    const glm::dvec3 rise{far_away * std::cos(angle), far_away * std::sin(angle), 0};
    scene.mesh = make_parallelogram({0, 0, -far_away}, along, rise, 2 * far_away);
    if (both) {
        append(scene.mesh, make_parallelogram({0, 0, -far_away}, {-rise.x, rise.y, 0}, along, 2 * far_away));
    }
    // Just above the line: to a plane without end every height is the same.
    for (int i = 0; i < 40; ++i) {
        Receiver receiver = on_ground(0.0, 0.1 * i);
        receiver.position.y = 0.01;
        scene.points.push_back({receiver, (both ? 1.0 : 0.5) * (1.0 - std::cos(angle))});
    }
    return scene;
}

// All directions alike: those up to the angle, of pi in each plane across the line.
inline KnownScene groove_seen_uniformly(double angle, bool both) {
    KnownScene scene = groove(angle, both);
    scene.name += ", uniform";
    scene.weighting = Weighting::uniform;
    for (KnownPoint& point : scene.points) point.occlusion = (both ? 2.0 : 1.0) * angle / std::numbers::pi;
    return scene;
}

}  // namespace gloam::scene::test
