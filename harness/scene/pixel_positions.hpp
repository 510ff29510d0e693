// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>

#include "scene/gbuffer.hpp"

namespace gloam::scene {

// Whether an eye-linear depth is that of a surface, not of the background.
[[nodiscard]] inline bool is_surface(float depth) {
    return depth > 0.0F && std::isfinite(depth);
}

// Conversion of pixels to view-space positions and back, in double.
class PixelPositions {
  public:
    explicit PixelPositions(const GBuffer& view)
        : width_(view.extent.width),
          size_(view.extent.width, view.extent.height),
          scale_(view.camera.p00_p11()),
          orthographic_(view.camera.orthographic()) {}

    // The point at an eye-linear depth under the centre of a pixel; pixels are counted by rows from the top.
    // aside: offset from the centre, pixels.
    [[nodiscard]] glm::dvec3 at(std::size_t pixel, double depth, const glm::dvec2& aside = {0, 0}) const {
        const glm::dvec2 center(static_cast<double>(pixel % width_) + 0.5,
                                static_cast<double>(pixel / width_) + 0.5);
        const glm::dvec2 ndc = 2.0 * (center + aside) / size_ - 1.0;
        return {ndc / scale_ * (orthographic_ ? 1.0 : depth), -depth};
    }

    // Position of a view-space point in the image, in pixels from the top left corner; the centre of the
    // first pixel is (0.5, 0.5). Perspective: only for points in front of the eye (z < 0).
    [[nodiscard]] glm::dvec2 pixel_of(const glm::dvec3& position) const {
        const glm::dvec2 ndc = scale_ * glm::dvec2(position) / (orthographic_ ? 1.0 : -position.z);
        return (0.5 * ndc + 0.5) * size_;
    }

    // Number of pixels that a length parallel to the image covers at a depth.
    [[nodiscard]] double pixels_of_length(double length, double depth) const {
        return 0.5 * length * glm::abs(scale_.y) * size_.y / (orthographic_ ? 1.0 : depth);
    }

    [[nodiscard]] bool orthographic() const { return orthographic_; }

  private:
    std::size_t width_;
    glm::dvec2 size_;
    glm::dvec2 scale_;
    bool orthographic_;
};

}  // namespace gloam::scene
