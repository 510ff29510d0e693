// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// A state of the history and the settings that the passes of a frame are timed in.
struct PassCase {
    std::string name;
    std::string what;    // in a few words
    Settings settings;   // of a radius of 1
    int warm = 0;        // frames of the first view before the one that is timed
    bool moves = false;  // the one that is timed shows a second view
    bool hoists = true;  // what a loop does not change is computed before it
};

// What a pass takes: the medians of its rounds.
struct PassCost {
    std::string pass;
    double ms = 0.0;
    double copies = 0.0;  // each round by the copy that was timed beside it
};

// The passes of the case's frame, in the order they run.
struct PassCosts {
    PassCase pass_case;
    std::vector<PassCost> passes;
};

struct PassStudy {
    double copy_ms = 0.0;  // a pass that reads one r32f texel and writes one
    // Passes that read one texel of a history and write it, by its precision: no pass that brings or blends
    // one can cost less.
    std::vector<PassCost> history_copies;
    std::vector<PassCosts> cases;
};

// A filter of 5 x 5 and one of 17 x 17 where nothing has converged, and where all has; the other filters;
// slices, and these with loops as they are written; a frame of a history that takes no samples, and one of a
// view that has moved, with each kind of history. Settled tiles are not left out: what their passes cost is
// what is timed.
[[nodiscard]] std::vector<PassCase> pass_cases();

// Times `rounds` frames of each case in the scene `columns`, the cases in turns, so that the machine's drift
// falls on all alike, each beside a copy. Throws std::invalid_argument for rounds below 1, std::runtime_error
// for a device without timestamps, and like AmbientOcclusion.
[[nodiscard]] PassStudy study_passes(const gpu::Device& device, const scene::PassLibrary& passes,
                                     gpu::Extent extent, int rounds);

}  // namespace gloam::effect
