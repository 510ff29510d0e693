// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "scene/pass_library.hpp"

namespace gloam::effect {

// A state of the history and settings, with which the passes of a frame are timed.
struct PassCase {
    std::string name;
    std::string what;    // in a few words
    Settings settings;   // of a radius of 1
    int warm = 0;        // frames of the first view before the timed one
    bool moves = false;  // the timed frame shows a second view
    bool hoists = true;  // the shader compiler hoists loop invariants, and drivers unroll short loops
    std::string scene = "columns";  // where objects move, the second view says where they were
};

// The cost of a pass: the medians of its rounds.
struct PassCost {
    std::string pass;
    double ms = 0.0;
    double copies = 0.0;  // in each round divided by the copy timed beside it
};

// The passes of the case's frame, in the order in which they run.
struct PassCosts {
    PassCase pass_case;
    std::vector<PassCost> passes;
};

struct PassStudy {
    double copy_ms = 0.0;  // a pass that reads one r32f texel and writes one
    // Passes that read one texel of a history and write it, by its precision: the lower bound for any pass
    // that reprojects or blends a history.
    std::vector<PassCost> history_copies;
    std::vector<PassCosts> cases;
};

// The cases: a filter of 5 x 5 and one of 17 x 17, where nothing has converged and where everything has; the
// other filters; slices, with and without hoisted loop invariants; and with each kind of history a frame that
// takes no samples and a frame of a view that has moved; few taps of three methods, in a single frame and
// where objects have moved. Settled tiles are not skipped, because the cost of their passes is what is timed.
[[nodiscard]] std::vector<PassCase> pass_cases();

// Times `rounds` frames of each case in its scene. The cases alternate, so that the machine's drift
// affects all of them alike, and a copy is timed beside each frame. Throws std::invalid_argument for rounds
// below 1, std::runtime_error for a device without timestamps, and like AmbientOcclusion.
[[nodiscard]] PassStudy study_passes(const gpu::Device& device, const scene::PassLibrary& passes,
                                     gpu::Extent extent, int rounds);

}  // namespace gloam::effect
