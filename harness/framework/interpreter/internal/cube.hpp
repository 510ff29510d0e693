// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "numeric/interval.hpp"

// The faces of cube maps: +x, -x, +y, -y, +z, -z (the sections "Cube Map Face Selection" to "Cube Map Edge
// Handling" of the Vulkan specification).
namespace gloam::interpreter::internal {

// A part of a direction's bounds that meets a face.
struct FacePoint {
    std::uint32_t face = 0;
    std::array<numeric::Bounds, 2> quotients{};  // the coordinates on it, -1 to 1
    numeric::Bounds major{};                     // the magnitude that divides the others
};

// All faces that a direction may select. Where two magnitudes are equal, or differ by less than `error` of
// themselves, either may be the largest. error = 0: one face, the largest's; of equal ones z before y, y
// before x.
[[nodiscard]] std::vector<FacePoint> faces_of(const std::array<numeric::Bounds, 4>& direction, double error);

// How fast the coordinates on the face, 0 to 1, change where the direction changes by these components.
[[nodiscard]] std::array<numeric::Bounds, 2> slope_on(const FacePoint& on,
                                                      const std::array<numeric::Bounds, 3>& change);

struct FaceTexel {
    std::uint32_t face = 0;
    long x = 0;
    long y = 0;
};

// The texel on a neighbouring face for one that is beyond one edge of its own; the same texel if it is beyond
// none. nullopt: it is beyond a corner.
[[nodiscard]] std::optional<FaceTexel> folded(const FaceTexel& texel, long size);

}  // namespace gloam::interpreter::internal
