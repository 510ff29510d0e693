// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "backend/vulkan/resources.hpp"
#include "base/hidden.hpp"
#include "effect/plan.hpp"
#include "effect/settings.hpp"
#include "effect/tile_work.hpp"
#include "scene/gbuffer.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// Time of a pass on the device, in milliseconds: the median over the runs of a frame. NaN where the device
// has no clock.
struct PassTime {
    std::string pass;
    double ms = 0.0;
};

// One frame, rows from the top, without the view's guard band. Occlusion is 1 where blocked, 0 at the
// background, always in [0, 1].
struct Frame {
    backend::Extent extent;
    std::vector<float> occlusion;    // the accumulated estimate, remapped where the settings say so
    std::vector<float> filtered;     // the same after the filter; equal to it with the filter off
    std::vector<float> convergence;  // of the estimate, in [0, 1]; 0 at the background, and without both a
                                     // history and a filter
    std::vector<float> kept;         // samples that the pixel's history holds; 0: it has no history
    std::vector<glm::vec3> bent;     // with Settings::bent_normals: the normal plus this, normalised, is the
                                     // mean of the open directions, in view space; 0 at the background
    std::vector<TileWork> tiles;     // of the view with its guard band, by rows
    std::vector<PassTime> times;     // in the order in which the passes ran
    double samples = 0.0;  // asked of a pixel with a surface, mean: k_1, or k_2 where it has converged
    std::uint64_t memory_bytes = 0;  // of the images and buffers that the passes used
};

// The ambient-occlusion passes, with their history.
class AmbientOcclusion {
  public:
    // The device must outlive this object. Throws std::runtime_error when a shader does not compile.
    AmbientOcclusion(const backend::vulkan::Device& device, const scene::PassLibrary& passes);

    // Takes a view and forgets the history. Missing normals are reconstructed from depth; the next frame's
    // times include that pass. If the view has a guard band (scene/gbuffer.hpp), the band is shaded as
    // well, and frames are cropped. Throws std::invalid_argument for settings out of range, and if the view
    // lacks the guard band or the layers that the settings ask for; std::runtime_error for a size of 0 or
    // beyond the device's limit.
    void begin(const scene::GBuffer& view, const Settings& settings);

    // Takes the next view of a moving camera or scene. The history follows the surfaces: by the view's
    // previous_position where objects move, otherwise by its camera. The history restarts if the view's
    // camera does not know the previous one (a cut), or if the size changes. Call begin() first, and next()
    // once for each view. Throws like begin().
    void advance(const scene::GBuffer& view);

    // Computes the next frame of the last view, after begin(). It runs `repeat` (>= 1) times and reports
    // median times, but the history advances only once. Throws std::runtime_error like
    // backend::vulkan::Commands::submit(). After a runtime error, for example a lost device, call begin()
    // again, on a new object if the device is lost.
    [[nodiscard]] Frame next(int repeat = 1);

    // From now on each pass is submitted alone, with a call of `watcher` before and after it. For tests of
    // single passes.
    void watch(PassWatcher watcher);

  private:
    struct Impl;
    base::Hidden<Impl> impl_;
};

}  // namespace gloam::effect
