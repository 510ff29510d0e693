// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "base/hidden.hpp"
#include "effect/settings.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// The directions in which points are open (CS-L), rows from the top, without the view's guard band.
struct BentNormals {
    backend::Extent extent;
    std::vector<glm::vec3>
        direction;  // mean: unit, view space; the normal where nothing is open, 0 at the background
    std::vector<float> half_angle;  // of the cone that represents them, radians in [0, pi / 2]
};

// Radiance of the sky by direction in the world, with +y up: mixed from horizon to zenith by the height. Any
// unit, >= 0, finite.
struct Sky {
    glm::vec3 zenith{1.0F};
    glm::vec3 horizon{1.0F};
    glm::vec3 ground{1.0F};  // everywhere below the horizon
};

// Blue at the zenith, white at the horizon, dim and brown below it.
inline const Sky clear_sky{{0.35F, 0.6F, 1.0F}, {1.0F, 1.0F, 1.0F}, {0.25F, 0.22F, 0.18F}};

// Radiance that leaves the surfaces (CS-D): linear, in the unit of the sky, 0 at the background. Rows from
// the top, without the guard band.
struct DirectionalLight {
    backend::Extent extent;
    std::vector<glm::vec3> direct;   // of the sky, from the open directions
    std::vector<glm::vec3> bounced;  // of that light after one bounce off the blockers
};

// Results by direction, from the depth buffer. The samples are points of the half ball around each pixel,
// uniform in direction and radius; each is blocked or open as in the method hemisphere. A frame takes
// Settings::samples samples, with the settings' radius, bias and range. MethodValues::epsilon is the
// least distance of a surface that sends light.
class Directional {
  public:
    // The device must outlive this object. Throws std::runtime_error when a shader does not compile.
    Directional(const backend::vulkan::Device& device, const scene::PassLibrary& passes);

    // Both throw std::invalid_argument for settings out of range and for images of another size. Missing
    // normals are reconstructed from depth. Each call takes its samples anew: there is no history.
    // interleave, 1 to 8: the pixels of a block with so
    // many on a side share one pattern of interleave^2 times as many samples (Klehm et al. 2011). Each takes
    // a part of it, then gathers the parts of the block around it from the pixels on its own surface. 1: no
    // sharing.
    [[nodiscard]] BentNormals bent_normals(const scene::GBuffer& view, const Settings& settings,
                                           int interleave = 1);

    [[nodiscard]] DirectionalLight light(const scene::GBuffer& view, const Settings& settings,
                                         const Sky& sky);

  private:
    struct Impl;
    base::Hidden<Impl> impl_;
};

}  // namespace gloam::effect
