// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

// Views of one size, and what is measured on them.
struct SkipCase {
    std::string name;
    std::string what;                   // in a few words
    std::vector<scene::GBuffer> views;  // one: the camera stands still
    int warm = 0;                       // frames of the first view before the first timed one
    int after = 0;  // frames of the last view before the timed one; 0: the second half of the views is timed
    Settings settings;    // with all skips
    double target = 0.0;  // largest ratio of the time with all skips to that without; 0: none
};

// Median times of all passes of a frame, in milliseconds. The measurements alternate, so that the machine's
// drift affects all alike.
struct SkipTimes {
    double without = 0.0;     // every skip off
    double with = 0.0;        // every skip on
    double background = 0.0;  // only this skip on
    double open = 0.0;
    double closed = 0.0;
    double settled = 0.0;
    double fresh = 0.0;            // every skip on, in the first frame of the same view
    double copy = 0.0;             // a pass that reads one r32f texel and writes one
    Work work;                     // of the last frame, every skip on
    std::vector<PassTime> passes;  // of that frame
};

// Median times of a frame with all skips and with none.
struct SkipPair {
    double without = 0.0;
    double with = 0.0;
    double copy = 0.0;
    Work work;  // of the last frame, every skip on
};

// The settings with every skip off.
[[nodiscard]] Settings without_skips(Settings settings);

// Runs cases with views of one size. Shared pipelines are compiled once.
class SkipStudy {
  public:
    // The device must outlive this object. Throws std::runtime_error for a device without timestamps, and
    // like AmbientOcclusion.
    SkipStudy(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent);

    // Times `rounds` runs of each way. Throws std::invalid_argument for a case without views, for views of
    // another size, and for rounds below 1.
    [[nodiscard]] SkipTimes times(const SkipCase& skip_case, int rounds);

    // The same for all skips and for none only.
    [[nodiscard]] SkipPair pair(const SkipCase& skip_case, int rounds);

  private:
    const gpu::Device* device_;
    scene::PassLibrary passes_;
    gpu::Extent extent_;
    AmbientOcclusion effect_;
};

}  // namespace gloam::effect
