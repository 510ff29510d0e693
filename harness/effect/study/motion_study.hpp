// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "effect/study/score.hpp"
#include "effect/study/sequence.hpp"
#include "effect/study/variants.hpp"

namespace gloam::effect {

struct MotionOptions {
    int every = 1;  // frames from one that is scored to the next, the first of them included
    std::function<void(double)> progress{};  // called with the part done, in [0, 1]
};

// The references of a frame.
using ReferencesOf = std::function<References(int frame, const SequenceFrame&)>;

// A run over the frames of a sequence.
struct MotionRun {
    Variant variant;
    std::vector<Score> scores;  // of the frames that are scored
    // Mean change of the filtered image since the frame before at the same points, over the classes, the mean
    // over the second half of the frames.
    std::array<double, pixel_classes> flicker{};
    std::vector<double> times_ms;  // on the device, of each frame
    Frame last;                    // of those that are scored
};

struct MotionStudy {
    std::vector<int> frames;      // that are scored
    std::vector<MotionRun> runs;  // of the variants, in their order
    References last;              // of the last frame that is scored
    std::vector<Score>
        single;  // a frame of its own each time, of k_1 samples: what an effect without history shows
    std::vector<Score> still;  // as many frames as the sequence has had, all of the view of that frame
};

// Runs all variants over a sequence, frame by frame in turn, so that their times are those of the same
// moments. The first variant's settings are those of `single` and `still`. Throws like AmbientOcclusion.
[[nodiscard]] MotionStudy study_motion(const gpu::Device& device, const scene::PassLibrary& passes,
                                       const std::vector<SequenceFrame>& sequence,
                                       const std::vector<Variant>& variants,
                                       const ReferencesOf& references_of, const MotionOptions& options);

// The median over the frames of one run's time divided by another's in the same frame. NaN for none.
[[nodiscard]] double time_ratio(const MotionRun& run, const MotionRun& base);

// All frames from `first` on together.
[[nodiscard]] Score total(const std::vector<Score>& scores, std::size_t first = 0);

}  // namespace gloam::effect
