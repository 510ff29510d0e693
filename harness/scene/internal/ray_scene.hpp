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

// Triangles for ray tracing; the only user of Embree. Every triangle blocks on both sides. Thread-safe.
class RayScene {
  public:
    // Throws std::invalid_argument if there are no triangles, an index is out of range or a position is not
    // finite; std::runtime_error if Embree fails.
    RayScene(std::vector<glm::vec3> positions, std::vector<std::uint32_t> indices);
    ~RayScene();
    RayScene(RayScene&&) noexcept;
    RayScene& operator=(RayScene&&) noexcept;

    [[nodiscard]] const std::vector<glm::vec3>& positions() const { return positions_; }
    [[nodiscard]] const std::vector<std::uint32_t>& indices() const { return indices_; }

    // The first triangle between the distances `near` and `far` along a unit direction. It traces one ray at
    // a time; for rays that diverge from a point this is 1.5 times as fast as packets of 16.
    [[nodiscard]] std::optional<RayHit> first_hit(const glm::vec3& origin, const glm::vec3& direction,
                                                  float near, float far) const;

  private:
    struct Impl;
    std::vector<glm::vec3> positions_;
    std::vector<std::uint32_t> indices_;
    std::unique_ptr<Impl> impl_;
};

}  // namespace gloam::scene
