// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "effect/settings.hpp"
#include "gpu/device.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// Depth buffers of further cameras (CS-LAYERS, multiple views): of all views that see a surface point, the
// one in which it is blocked most decides.
class FurtherViews {
  public:
    // The device must outlive this.
    FurtherViews(const gpu::Device& device, const scene::PassLibrary& passes);
    ~FurtherViews();
    FurtherViews(FurtherViews&&) noexcept;
    FurtherViews& operator=(FurtherViews&&) noexcept;

    // The occlusion of a view, as AmbientOcclusion gives it, raised by one frame of the same settings in each
    // of the others, which may be of any size and projection: of their first layers, without history or
    // filter. Views are without guard bands; normals that are missing come from the depth. Throws
    // std::invalid_argument for sizes that disagree, for settings out of range, for a method with preparation
    // passes and for a guard band.
    [[nodiscard]] std::vector<float> raised(const scene::GBuffer& view, const std::vector<float>& occlusion,
                                            std::span<const scene::GBuffer> others, const Settings& settings);

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace gloam::effect
