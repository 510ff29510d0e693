// SPDX-License-Identifier: MIT
#include "scene/depth_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "scene/pixel_positions.hpp"

namespace gloam::scene {
namespace {

// Determines which neighbouring pixels belong to one surface.
class Connections {
  public:
    Connections(const GBuffer& view, double thickness)
        : depth_(view.depth),
          width_(static_cast<long>(view.extent.width)),
          height_(static_cast<long>(view.extent.height)),
          orthographic_(view.camera.orthographic()),
          thickness_(thickness) {}

    // Between two neighbouring pixels, (x, y) and (x + dx, y + dy).
    [[nodiscard]] bool connected(long x, long y, long dx, long dy) const {
        const float a = at(x, y);
        const float b = at(x + dx, y + dy);
        if (!is_surface(a) || !is_surface(b)) return false;
        if (std::isinf(thickness_) || std::abs(double{a} - double{b}) <= thickness_) return true;
        return continues(at(x - dx, y - dy), a, b) || continues(at(x + 2 * dx, y + 2 * dy), b, a);
    }

    // Whether all four pixels of a block are connected. (x, y): its first pixel.
    [[nodiscard]] bool block(long x, long y) const {
        return connected(x, y, 1, 0) && connected(x, y, 0, 1) && connected(x, y + 1, 1, 0) &&
               connected(x + 1, y, 0, 1);
    }

  private:
    [[nodiscard]] float at(long x, long y) const {
        if (x < 0 || y < 0 || x >= width_ || y >= height_) return 0.0F;
        return depth_[static_cast<std::size_t>(y * width_ + x)];
    }

    // Whether the slope from `first` to `second`, one pixel apart, continues to `third` within the thickness.
    [[nodiscard]] bool continues(float first, float second, float third) const {
        if (!is_surface(first)) return false;
        if (orthographic_) return std::abs(2.0 * second - first - third) <= thickness_;
        const double expected = 2.0 / second - 1.0 / first;
        return std::abs(expected - 1.0 / third) * third * third <= thickness_;
    }

    const std::vector<float>& depth_;
    long width_;
    long height_;
    bool orthographic_;
    double thickness_;
};

// Along an axis, the difference of positions to the neighbour that is nearer in depth, with the sign of the
// positive direction; 0 without a neighbour.
glm::dvec3 slope_at(const GBuffer& view, const PixelPositions& positions, long x, long y, bool vertical) {
    const auto width = static_cast<long>(view.extent.width);
    const long index = y * width + x;
    const long place = vertical ? y : x;
    const long last = static_cast<long>(vertical ? view.extent.height : view.extent.width) - 1;
    const double depth = view.depth[static_cast<std::size_t>(index)];
    const glm::dvec3 here = positions.at(static_cast<std::size_t>(index), depth);
    glm::dvec3 best(0.0);
    double least = std::numeric_limits<double>::infinity();
    for (const long side : {-1L, 1L}) {
        if (place + side < 0 || place + side > last) continue;
        const auto other = static_cast<std::size_t>(index + side * (vertical ? width : 1));
        if (!is_surface(view.depth[other])) continue;
        const double jump = std::abs(view.depth[other] - depth);
        if (!(jump < least)) continue;
        least = jump;
        best = static_cast<double>(side) * (positions.at(other, view.depth[other]) - here);
    }
    return best;
}

glm::vec3 normal_at(const GBuffer& view, const PixelPositions& positions, long x, long y) {
    const glm::dvec3 right = slope_at(view, positions, x, y, false);
    const glm::dvec3 down = slope_at(view, positions, x, y, true);
    const glm::dvec3 area = glm::cross(down, right);
    if (glm::length(area) > 0.0) return {glm::normalize(area)};
    return {0, 0, 1};  // a surface of a single pixel: facing the viewer
}

void require(bool condition, const std::string& message) {
    if (!condition) throw std::invalid_argument("depth field: " + message);
}

void check(const GBuffer& view, double thickness) {
    const std::size_t pixels = std::size_t{view.extent.width} * view.extent.height;
    require(view.depth.size() == pixels, fmt::format("{} depths for {} x {} pixels", view.depth.size(),
                                                     view.extent.width, view.extent.height));
    require(view.normal.empty() || view.normal.size() == pixels,
            fmt::format("{} normals for {} pixels", view.normal.size(), pixels));
    require(thickness > 0.0, fmt::format("thickness {}, expected > 0", thickness));
    require(std::ranges::any_of(view.depth, is_surface), "no geometry in the view");
}

}  // namespace

Mesh depth_field(const GBuffer& view, double thickness) {
    check(view, thickness);
    const PixelPositions positions(view);
    const auto width = static_cast<long>(view.extent.width);
    Mesh mesh;
    for (std::size_t pixel = 0; pixel < view.depth.size(); ++pixel) {
        const auto x = static_cast<long>(pixel) % width;
        const auto y = static_cast<long>(pixel) / width;
        const bool surface = is_surface(view.depth[pixel]);
        mesh.positions.emplace_back(surface ? positions.at(pixel, double{view.depth[pixel]}) : glm::dvec3(0));
        mesh.normals.push_back(!surface              ? glm::vec3(0)
                               : view.normal.empty() ? normal_at(view, positions, x, y)
                                                     : view.normal[pixel]);
    }
    const Connections connections(view, thickness);
    for (long y = 0; y + 1 < static_cast<long>(view.extent.height); ++y) {
        for (long x = 0; x + 1 < width; ++x) {
            if (!connections.block(x, y)) continue;
            const auto corner = static_cast<std::uint32_t>(y * width + x);
            const auto below = static_cast<std::uint32_t>(corner + width);
            mesh.indices.insert(mesh.indices.end(),
                                {corner, below, corner + 1, corner + 1, below, below + 1});
        }
    }
    return mesh;
}

}  // namespace gloam::scene
