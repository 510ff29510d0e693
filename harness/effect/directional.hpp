// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "effect/pass_watcher.hpp"
#include "effect/settings.hpp"
#include "gpu/device.hpp"
#include "scene/environment.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// The directions in which points are open (CS-L), rows from the top, without the view's guard band.
struct BentNormals {
    gpu::Extent extent;
    std::vector<glm::vec3>
        direction;  // their mean: unit, view space; the normal where nothing is open, 0 at the background
    std::vector<float> half_angle;  // of the cone that stands for them, radians in [0, pi / 2]
};

// Interleaved sampling (Klehm et al. 2011). The pixels of a block, `interleave` on a side, share a pattern
// of interleave^2 times as many samples, and each pixel takes its part. Then each pixel gathers the parts
// of a block around it, from the pixels that lie on its surface. 1: each pixel by itself. 1 to 8.
struct BentOptions {
    int interleave = 1;
};

// Radiance that leaves the surfaces (CS-D), linear, in the environment's unit, rows and band as above; 0 at
// the background.
struct DirectionalLight {
    gpu::Extent extent;
    std::vector<glm::vec3> direct;   // of the environment's light, from where the point is open
    std::vector<glm::vec3> bounced;  // of that light, bounced once off the blockers
};

// Results by direction from the depth buffer. Points of the half ball around each pixel, uniform in
// direction and radius, are blocked or not as for the method hemisphere. Each result is of one frame of
// Settings::samples samples, with its radius, bias, range and layers, and without history. Its epsilon is
// the least distance of a surface that sends light.
class Directional {
  public:
    // The device must outlive this. Throws std::runtime_error when a shader does not compile.
    Directional(const gpu::Device& device, const scene::PassLibrary& passes);
    ~Directional();
    Directional(Directional&&) noexcept;
    Directional& operator=(Directional&&) noexcept;

    // Both throw std::invalid_argument for settings out of range, images whose size disagrees, and fewer
    // layers than the settings ask for, the first for options out of range. Normals that are missing are
    // reconstructed from depth.
    [[nodiscard]] BentNormals bent_normals(const scene::GBuffer& view, const Settings& settings,
                                           const BentOptions& options = {});
    [[nodiscard]] DirectionalLight light(const scene::GBuffer& view, const Settings& settings,
                                         const scene::Environment& environment);

    // From now on each pass is watched: for tests of the passes alone.
    void watch(PassWatcher watcher);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace gloam::effect
