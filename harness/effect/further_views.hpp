// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "effect/pass_watcher.hpp"
#include "effect/settings.hpp"
#include "gpu/device.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// Depth buffers of further cameras (CS-LAYERS, multiple views). Of all views that see a surface point, the
// one with the largest occlusion counts.
class FurtherViews {
  public:
    // The device must outlive this.
    FurtherViews(const gpu::Device& device, const scene::PassLibrary& passes);
    ~FurtherViews();
    FurtherViews(FurtherViews&&) noexcept;
    FurtherViews& operator=(FurtherViews&&) noexcept;

    // The occlusion of a view, as AmbientOcclusion gives it, raised to that of one frame of the same
    // settings in each of the other views. These may have any size and projection; only their first layers
    // count, without history or filter. Views have no guard bands. Missing normals are reconstructed from
    // depth. Throws std::invalid_argument for sizes that disagree, for settings out of range, for a method
    // with preparation passes and for a guard band.
    [[nodiscard]] std::vector<float> raised(const scene::GBuffer& view, const std::vector<float>& occlusion,
                                            std::span<const scene::GBuffer> others, const Settings& settings);

    // From now on each pass is watched: for tests of the passes alone.
    void watch(PassWatcher watcher);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace gloam::effect
