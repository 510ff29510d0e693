// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "base/hidden.hpp"
#include "effect/plan.hpp"
#include "effect/settings.hpp"
#include "scene/gbuffer.hpp"
#include "scene/image_files.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// The directions in which points are open (CS-L), rows from the top, without the view's guard band.
struct BentNormals {
    gpu::Extent extent;
    std::vector<glm::vec3>
        direction;  // mean: unit, view space; the normal where nothing is open, 0 at the background
    std::vector<float> half_angle;  // of the cone that represents them, radians in [0, pi / 2]
};

// Interleaved sampling (Klehm et al. 2011). The pixels of a block with `interleave` pixels on a side share
// one pattern of interleave^2 times as many samples. Each pixel takes a part of it, then gathers the parts of
// the block around it from the pixels on its own surface. Range: 1 to 8; 1: no sharing.
struct BentOptions {
    int interleave = 1;
};

// What a frame of light has to do with the frame before it.
enum class LightFollows {
    nothing,    // it has no history
    last_view,  // its view is the next one of a sequence
    same_view   // it is a further frame of the last view
};

// Radiance that leaves the surfaces (CS-D): linear, in the environment's unit, 0 at the background. Rows from
// the top, without the guard band.
struct DirectionalLight {
    gpu::Extent extent;
    std::vector<glm::vec3> direct;   // of the environment's light, from the open directions
    std::vector<glm::vec3> bounced;  // of that light after one bounce off the blockers
};

// Results by direction, from the depth buffer. The samples are points of the half ball around each pixel,
// uniform in direction and radius; each is blocked or open as in the method hemisphere. A frame takes
// Settings::samples samples, with the settings' radius, bias, range and layers. MethodValues::epsilon is the
// least distance of a surface that sends light.
class Directional {
  public:
    // The device must outlive this object. Throws std::runtime_error when a shader does not compile.
    Directional(const gpu::Device& device, const scene::PassLibrary& passes);

    // Both throw std::invalid_argument for settings out of range, for images of another size, and if the view
    // has fewer layers than the settings ask for; bent_normals() also for options out of range. Missing
    // normals are reconstructed from depth. bent_normals() has no history.
    [[nodiscard]] BentNormals bent_normals(const scene::GBuffer& view, const Settings& settings,
                                           const BentOptions& options = {});

    // The mean over the frames since the last one that follows nothing, kept and dropped as the history of
    // the occlusion. All these frames should have the same settings and environment. A view of another size,
    // or whose camera does not know the previous one, follows nothing. Where Settings::filter is on, the
    // result is smoothed by the convergence filter, whichever filter the settings name.
    [[nodiscard]] DirectionalLight light(const scene::GBuffer& view, const Settings& settings,
                                         const scene::Environment& environment,
                                         LightFollows follows = LightFollows::nothing);

    // From now on each pass is watched: for tests of the passes alone.
    void watch(PassWatcher watcher);

  private:
    struct Impl;
    base::Hidden<Impl> impl_;
};

}  // namespace gloam::effect
