// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "effect/ambient_occlusion.hpp"
#include "effect/plan.hpp"

namespace gloam::effect {

// The passes of one kind of frame (Settings::passes), with their images and their history.
class FramePasses {
  public:
    virtual ~FramePasses() = default;

    // Takes a view, as its engine stores it. follows: the view continues the last one, whose history it has
    // if its camera knows the one before; otherwise a sequence begins. Throws std::invalid_argument for what
    // the passes do not take.
    virtual void take(const scene::GBuffer& view, const Settings& settings, bool follows) = 0;

    // A frame of the last view, as AmbientOcclusion::next() has it, but for its tiles: those that are marked
    // are full, all others half; none where no tile is marked apart.
    [[nodiscard]] virtual Frame next(int repeat, const PassWatcher& watcher) = 0;
};

// The device must outlive the passes. Study: TSSAO as printed. Frame: the three short passes for engines.
[[nodiscard]] std::unique_ptr<FramePasses> study_passes(const backend::vulkan::Device& device,
                                                        const scene::PassLibrary& passes);
[[nodiscard]] std::unique_ptr<FramePasses> frame_passes(const backend::vulkan::Device& device,
                                                        const scene::PassLibrary& passes);

// The plan of a frame of those three, for a radius of 1.
[[nodiscard]] Plan frame_plan(const Settings& settings, const PlanOptions& options);

// The plan of a frame of this view, as its engine stores it, that follows none.
[[nodiscard]] Plan frame_plan(const Settings& settings, const scene::GBuffer& view);

// The images of a frame without the view's guard band.
void crop(const scene::GBuffer& shape, Frame& frame);

}  // namespace gloam::effect
