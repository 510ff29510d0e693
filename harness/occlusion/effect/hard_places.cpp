// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <optional>

#include "effect/pixel_classes.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {
namespace {

// Parts of the radius.
constexpr double contact = 0.1;
constexpr double half_width = 0.25;      // of what is thin
constexpr double step = 0.1;             // of depth, beside what is thin
constexpr double sine_of_rise = 0.2588;  // 15 degrees
constexpr long most_pixels = 64;         // that are searched to each side

class Places {
  public:
    Places(const scene::GBuffer& view, double radius) : view_(view), positions_(view), radius_(radius) {}

    [[nodiscard]] bool is_surface(std::size_t pixel) const { return scene::is_surface(view_.depth[pixel]); }

    // A part of the radius at a pixel, in pixels.
    [[nodiscard]] double pixels_of(double part, std::size_t pixel) const {
        return positions_.pixels_of_length(part * radius_, double{view_.depth[pixel]});
    }

    [[nodiscard]] bool touches(std::size_t pixel) const {
        const long reach = search(contact, pixel);
        const glm::dvec3 point = positions_.at(pixel, double{view_.depth[pixel]});
        const glm::dvec3 normal = glm::normalize(glm::dvec3(view_.normal[pixel]));
        for (long y = -reach; y <= reach; ++y) {
            for (long x = -reach; x <= reach; ++x) {
                const auto other = beside(pixel, x, y);
                if (!other || !is_surface(*other)) continue;
                const glm::dvec3 offset = positions_.at(*other, double{view_.depth[*other]}) - point;
                const double apart = glm::length(offset);
                if (apart <= contact * radius_ && glm::dot(offset, normal) > sine_of_rise * apart)
                    return true;
            }
        }
        return false;
    }

    // Whether the depth falls off to both sides, along a row or a column.
    [[nodiscard]] bool is_thin(std::size_t pixel) const {
        return (falls(pixel, -1, 0) && falls(pixel, 1, 0)) || (falls(pixel, 0, -1) && falls(pixel, 0, 1));
    }

    [[nodiscard]] double from_edge(std::size_t pixel) const {
        const std::size_t x = pixel % view_.extent.width;
        const std::size_t y = pixel / view_.extent.width;
        return static_cast<double>(std::min({x, y, view_.extent.width - 1 - x, view_.extent.height - 1 - y}));
    }

  private:
    [[nodiscard]] long search(double part, std::size_t pixel) const {
        return static_cast<long>(std::clamp(std::ceil(pixels_of(part, pixel)), 1.0, double{most_pixels}));
    }

    [[nodiscard]] std::optional<std::size_t> beside(std::size_t pixel, long x, long y) const {
        const auto width = static_cast<long>(view_.extent.width);
        const long column = static_cast<long>(pixel) % width + x;
        const long row = static_cast<long>(pixel) / width + y;
        if (column < 0 || row < 0 || column >= width || row >= static_cast<long>(view_.extent.height))
            return std::nullopt;
        return static_cast<std::size_t>(row * width + column);
    }

    [[nodiscard]] bool falls(std::size_t pixel, long x, long y) const {
        const long reach = search(half_width, pixel);
        for (long i = 1; i <= reach; ++i) {
            const auto other = beside(pixel, i * x, i * y);
            if (!other) return false;
            const double further = double{view_.depth[*other]} - double{view_.depth[pixel]};
            if (!is_surface(*other) || further > step * radius_) return true;
        }
        return false;
    }

    const scene::GBuffer& view_;
    scene::PixelPositions positions_;
    double radius_;
};

}  // namespace

HardPlaces hard_places(const scene::GBuffer& view, double radius) {
    const Places places(view, radius);
    const std::size_t pixels = view.depth.size();
    HardPlaces found{Mask(pixels, 0), Mask(pixels, 0), Mask(pixels, 0)};
    Mask on_thin(pixels, 0);
    for (std::size_t i = 0; i < pixels; ++i) {
        if (!places.is_surface(i)) continue;
        found.contacts[i] = places.touches(i) ? 1 : 0;
        found.rim[i] = places.from_edge(i) < places.pixels_of(1.0, i) ? 1 : 0;
        on_thin[i] = places.is_thin(i) ? 1 : 0;
    }
    const std::vector<float> from_thin = distance_to(on_thin, view.extent);
    for (std::size_t i = 0; i < pixels; ++i)
        if (places.is_surface(i))
            found.thin[i] = double{from_thin[i]} <= places.pixels_of(half_width, i) ? 1 : 0;
    return found;
}

}  // namespace gloam::effect
