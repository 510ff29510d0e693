// SPDX-License-Identifier: MIT
#include "scene/closed_parts.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <tuple>

namespace gloam::scene {
namespace {

using Indices = std::vector<std::uint32_t>;

// The same number for equal positions.
Indices welded(const Mesh& mesh) {
    const auto key = [&](std::uint32_t i) {
        const glm::vec3& p = mesh.positions[i];
        return std::tuple(p.x, p.y, p.z);
    };
    Indices order(mesh.positions.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    Indices numbers(order.size(), 0);
    for (std::size_t i = 1; i < order.size(); ++i)
        numbers[order[i]] = key(order[i]) == key(order[i - 1]) ? numbers[order[i - 1]] : order[i];
    if (!order.empty()) numbers[order[0]] = order[0];
    return numbers;
}

// What is known about a part.
struct Part {
    std::size_t edges = 0;
    std::size_t one_way = 0;  // edges that are not passed as often in one direction as in the other
    bool has_border = false;  // an edge of a single triangle
    double volume = 0.0;
    Bounds bounds{glm::dvec3(1e300), glm::dvec3(-1e300)};

    [[nodiscard]] bool closed() const { return !has_border && 100 * one_way <= edges && volume > 0.0; }
};

// The parts of a mesh.
class Parts {
  public:
    explicit Parts(const Mesh& mesh) : mesh_(mesh), numbers_(welded(mesh)), root_(numbers_.size()) {
        std::iota(root_.begin(), root_.end(), 0U);
        for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
            for (std::size_t k = 1; k < 3; ++k) root_[find(corner(t, k))] = find(corner(t, 0));
        parts_.resize(numbers_.size());
        measure();
        count_edges();
    }

    [[nodiscard]] const Part& of(std::size_t triangle) const { return parts_[root_of(triangle)]; }

  private:
    [[nodiscard]] std::uint32_t corner(std::size_t triangle, std::size_t k) const {
        return numbers_[mesh_.indices[3 * triangle + k]];
    }
    std::uint32_t find(std::uint32_t i) {
        while (root_[i] != i) i = root_[i] = root_[root_[i]];
        return i;
    }
    [[nodiscard]] std::uint32_t root_of(std::size_t triangle) const {
        std::uint32_t i = corner(triangle, 0);
        while (root_[i] != i) i = root_[i];
        return i;
    }

    void measure() {
        for (std::size_t t = 0; t < mesh_.triangle_count(); ++t) {
            Part& part = parts_[root_of(t)];
            std::array<glm::dvec3, 3> p;
            for (std::size_t k = 0; k < 3; ++k) {
                p[k] = mesh_.positions[corner(t, k)];
                part.bounds.low = glm::min(part.bounds.low, p[k]);
                part.bounds.high = glm::max(part.bounds.high, p[k]);
            }
            part.volume += glm::dot(p[0], glm::cross(p[1], p[2])) / 6.0;
        }
    }

    void count_edges() {
        struct Edge {
            std::uint32_t low;
            std::uint32_t high;
            std::uint32_t triangle;
            bool forward;
        };
        std::vector<Edge> edges;
        for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = corner(t, k);
                const std::uint32_t b = corner(t, (k + 1) % 3);
                if (a != b) edges.push_back({std::min(a, b), std::max(a, b), t, a < b});
            }
        }
        std::ranges::sort(edges, {}, [](const Edge& e) { return std::pair(e.low, e.high); });
        for (auto first = edges.begin(); first != edges.end();) {
            const auto last = std::find_if(first, edges.end(), [&](const Edge& e) {
                return std::pair(e.low, e.high) != std::pair(first->low, first->high);
            });
            Part& part = parts_[root_of(first->triangle)];
            const auto forward = std::count_if(first, last, [](const Edge& e) { return e.forward; });
            ++part.edges;
            part.has_border = part.has_border || last - first < 2;
            part.one_way += 2 * forward != last - first ? 1 : 0;
            first = last;
        }
    }

    const Mesh& mesh_;
    Indices numbers_;
    Indices root_;
    std::vector<Part> parts_;  // by the number of their first position
};

}  // namespace

std::vector<bool> hidden_far_sides(const Mesh& view_space, bool orthographic) {
    const Parts parts(view_space);
    std::vector<bool> hidden;
    for (std::size_t t = 0; t < view_space.triangle_count(); ++t) {
        const Part& part = parts.of(t);
        const auto p = [&](std::size_t k) {
            return glm::dvec3(view_space.positions[view_space.indices[3 * t + k]]);
        };
        const glm::dvec3 front = glm::cross(p(1) - p(0), p(2) - p(0));
        const glm::dvec3 away = orthographic ? glm::dvec3(0, 0, -1) : p(0);
        const bool inside = glm::all(glm::lessThanEqual(part.bounds.low, glm::dvec3(0))) &&
                            glm::all(glm::greaterThanEqual(part.bounds.high, glm::dvec3(0)));
        hidden.push_back(part.closed() && !inside && glm::dot(front, away) >= 0.0);
    }
    return hidden;
}

}  // namespace gloam::scene
