// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "scene/gbuffer.hpp"

namespace gloam::effect {

// Views of one size, and what is measured of them.
struct SkipCase {
    std::string name;
    std::string what;                   // in a few words
    std::vector<scene::GBuffer> views;  // one: of a camera that stands still
    int warm = 0;                       // frames before the first that is timed, of the first view
    int after = 0;        // frames of the last view before the one that is timed; 0: of two or more views the
                          // second half is
    Settings settings;    // with all skips
    double target = 0.0;  // of the time with all skips, as a part of that without; 0: none
};

// Median times of all passes of a frame, in milliseconds, interleaved so that the machine's drift falls on
// all alike.
struct SkipTimes {
    double without = 0.0;     // every skip off
    double with = 0.0;        // every skip on
    double background = 0.0;  // only this one on
    double open = 0.0;
    double closed = 0.0;
    double settled = 0.0;
    double fresh = 0.0;            // every skip on, in the first frame of the same view
    double copy = 0.0;             // a pass that reads one r32f texel and writes one
    Work work;                     // of the last frame, every skip on
    std::vector<PassTime> passes;  // of that frame
};

// Median times as above, of all skips and of none.
struct SkipPair {
    double without = 0.0;
    double with = 0.0;
    double copy = 0.0;
    Work work;  // of the last frame, every skip on
};

// Every skip off.
[[nodiscard]] Settings without_skips(Settings settings);

// Runs cases of views of one size; what they share of the passes is compiled once.
class SkipStudy {
  public:
    // The device must outlive this. Throws std::runtime_error for a device without timestamps, and like
    // AmbientOcclusion.
    SkipStudy(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent);

    // Times `rounds` runs of each way. Throws std::invalid_argument for a case without views, or with views
    // of another size, and for rounds below 1.
    [[nodiscard]] SkipTimes times(const SkipCase& skip_case, int rounds);

    // The same of two ways alone.
    [[nodiscard]] SkipPair pair(const SkipCase& skip_case, int rounds);

  private:
    const gpu::Device* device_;
    scene::PassLibrary passes_;
    gpu::Extent extent_;
    AmbientOcclusion effect_;
};

}  // namespace gloam::effect
