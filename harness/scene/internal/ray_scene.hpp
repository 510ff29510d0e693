// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <vector>

namespace gloam::scene {

// The first triangle along a ray.
struct RayHit {
    std::uint32_t triangle = 0;
    float distance = 0.0F;
};

// Triangles that rays are traced against: the only user of Embree. Every triangle blocks on both sides. May
// be used by several threads at once.
class RayScene {
  public:
    // Throws std::invalid_argument for no triangles, indices that do not fit or a position that is not
    // finite, std::runtime_error when Embree cannot.
    RayScene(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices);
    ~RayScene();
    RayScene(RayScene&&) noexcept;
    RayScene& operator=(RayScene&&) noexcept;

    [[nodiscard]] const std::vector<glm::vec3>& positions() const { return positions_; }
    [[nodiscard]] const std::vector<std::uint32_t>& indices() const { return indices_; }

    // The first triangle between the distances `near` and `far` along a unit direction. One ray at a time: on
    // rays that spread from a point it is half as fast again as packets of 16.
    [[nodiscard]] std::optional<RayHit> first_hit(const glm::vec3& origin, const glm::vec3& direction,
                                                  float near, float far) const;

  private:
    struct Impl;
    std::vector<glm::vec3> positions_;
    std::vector<std::uint32_t> indices_;
    std::unique_ptr<Impl> impl_;
};

}  // namespace gloam::scene
