// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "effect/pixel_classes.hpp"
#include "effect/settings.hpp"
#include "effect/study/still_study.hpp"
#include "scene/rasterize.hpp"

namespace gloam::effect {

// The guard band that is compared with no guard band, share of the frame on each side.
constexpr double study_guard = 0.1;

// A frame of a moving scene, with further data about its pixels.
struct SequenceFrame {
    scene::GBuffer view;
    scene::GBuffer wide;                // the same with a guard band of study_guard
    std::optional<HistoryMap> history;  // from the previous frame; none in the first
    PixelClasses classes;
};

// The first frames of a scene, rendered once for all comparisons. Throws like scene::rasterize().
[[nodiscard]] std::vector<SequenceFrame> sequence_of(const gpu::Device& device,
                                                     const scene::PassLibrary& passes,
                                                     const scene::Scene& scene, gpu::Extent extent,
                                                     int frames);

// The view as it would be if nothing had moved since the previous frame.
[[nodiscard]] scene::GBuffer standing_still(scene::GBuffer view);

// The effect with one mechanism switched off.
struct Variant {
    std::string name;     // of what is switched off; "full" for nothing
    std::string instead;  // what replaces the mechanism
    Settings settings;
};

// The full effect, then one variant for each mechanism of the temporal effect, with that mechanism switched
// off.
[[nodiscard]] std::vector<Variant> ablations_of(const Settings& full);

struct MotionOptions {
    int every = 1;                           // every how many frames one is scored; the first frame is scored
    std::function<void(double)> progress{};  // called with the part done, in [0, 1]
};

// A function that returns the references of a frame.
using ReferencesOf = std::function<References(int frame, const SequenceFrame&)>;

// The results of one variant over the frames of a sequence.
struct MotionRun {
    Variant variant;
    std::vector<Score> scores;  // of the scored frames
    // Flicker of the filtered image for each class of pixels: mean change since the previous frame at the
    // same points, over the second half of the frames.
    std::array<double, pixel_classes> flicker{};
    std::vector<double> times_ms;  // on the device, of each frame
    Frame last;                    // the last scored frame
};

struct MotionStudy {
    std::vector<int> frames;      // numbers of the scored frames
    std::vector<MotionRun> runs;  // of the variants, in their order
    References last;              // of the last scored frame
    std::vector<Score> single;  // an independent frame each time, with k_1 samples: an effect without history
    std::vector<Score> still;   // as many frames as the sequence has had so far, all of that frame's view
};

// Runs all variants through a sequence. Each frame runs all variants in turn, so that their times are
// measured at the same moments. `single` and `still` use the first variant's settings. Throws like
// AmbientOcclusion.
[[nodiscard]] MotionStudy study_motion(const gpu::Device& device, const scene::PassLibrary& passes,
                                       const std::vector<SequenceFrame>& sequence,
                                       const std::vector<Variant>& variants,
                                       const ReferencesOf& references_of, const MotionOptions& options);

// The median over the frames of the ratio of two runs' times in the same frame. NaN without frames.
[[nodiscard]] double time_ratio(const MotionRun& run, const MotionRun& base);

// The sum of the scores of all frames from `first` on.
[[nodiscard]] Score total(const std::vector<Score>& scores, std::size_t first = 0);

}  // namespace gloam::effect
