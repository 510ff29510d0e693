// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "base/hidden.hpp"
#include "effect/plan.hpp"
#include "effect/settings.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// Depth buffers of further cameras (CS-LAYERS, multiple views). A surface point takes the largest occlusion
// of all views that see it.
class FurtherViews {
  public:
    // The device must outlive this object.
    FurtherViews(const gpu::Device& device, const scene::PassLibrary& passes);

    // The occlusion of a view, raised to that of each further view where that is larger. `occlusion`: of the
    // view, as AmbientOcclusion returns it. Each further view is sampled for one frame with the same
    // settings, in its first layer alone, without history and filter. Further views may have any size and
    // projection.
    // Missing normals are reconstructed from depth. Throws std::invalid_argument for sizes that disagree, for
    // settings out of range, for a method with preparation passes and for a guard band.
    [[nodiscard]] std::vector<float> raised(const scene::GBuffer& view, const std::vector<float>& occlusion,
                                            std::span<const scene::GBuffer> others, const Settings& settings);

    // From now on each pass is watched: for tests of the passes alone.
    void watch(PassWatcher watcher);

  private:
    struct Impl;
    base::Hidden<Impl> impl_;
};

}  // namespace gloam::effect
