// SPDX-License-Identifier: MIT
#pragma once

#include "effect/ambient_occlusion.hpp"
#include "effect/plan.hpp"

namespace gloam::effect {

// The frame of three short passes (glsl/passes/frame): prepare, sweep, and filter or join. Settings have
// Passes::frame.

// Its plan, for a radius of 1.
[[nodiscard]] Plan frame_plan(const Settings& settings, const PlanOptions& options);

// The plan of a frame of this view, as its engine stores it, that follows none.
[[nodiscard]] Plan frame_plan(const Settings& settings, const scene::GBuffer& view);

// Frames by these passes.
class ShortFrame {
  public:
    // The device must outlive this object.
    ShortFrame(const gpu::Device& device, const scene::PassLibrary& passes);

    // Takes a view, as its engine stores it. Missing normals are made from depth by the sweep. A view that
    // follows the last one, with a camera that knows the one before or is the same, has its history;
    // otherwise a sequence begins. Throws std::invalid_argument for images of another size than the view's.
    void take(const scene::GBuffer& view, const Settings& settings, bool follows);

    // A frame of the last view, as AmbientOcclusion::next() has it.
    [[nodiscard]] Frame next(int repeat, const PassWatcher& watcher);

  private:
    struct Impl;
    base::Hidden<Impl> impl_;
};

}  // namespace gloam::effect
