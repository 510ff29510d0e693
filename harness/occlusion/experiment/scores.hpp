// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/errors.hpp"
#include "effect/pixel_classes.hpp"
#include "effect/settings.hpp"

namespace gloam::experiment {

// "all"; effect::pixel_class_names; and the places of effect::HardPlaces, "contacts", "thin" and "rim".
[[nodiscard]] const std::vector<std::string>& pixel_classes();

// The classes of a view's pixels.
struct ClassedView {
    effect::PixelClasses classes;
    std::optional<effect::HardPlaces> places;  // where BenchmarkFrames ask for them
};

// Whether a class is one of effect::HardPlaces.
[[nodiscard]] bool is_place(const std::string& name);

// The mask of a class; of "all" an empty one. A place needs ClassedView::places.
[[nodiscard]] effect::Mask mask_of(const ClassedView& view, const std::string& name);

// The truth of a scored view, and what else its score needs. Empty where it is not asked for.
struct ScoredView {
    effect::Truth geometry;                     // (G)
    effect::Truth depth;                        // (D)
    std::optional<effect::HistoryMap> history;  // from the view before
    std::vector<float> due;  // change of (G) since then at the same surface points; empty: none
};

// Errors of the pixels of one class against one reference, as sums, so that those of frames can be added.
struct ClassScore {
    std::string pixels;        // the class
    std::string against;       // the depth truth (D) "depth" or the geometry truth (G) "geometry"
    std::uint64_t count = 0;   // of pixels
    double squares = 0.0;      // of the displayed image's errors
    double raw_squares = 0.0;  // of the estimate's
    double raw_errors = 0.0;
};

struct FrameScore {
    int frame = 0;                    // from 1 on
    double samples = 0.0;             // taken by a pixel so far, mean over the pixels that need samples
    std::vector<ClassScore> classes;  // those with a pixel
};

// Change of the error at the same surface points since the frame before: mean magnitude, mean over the scored
// frames in which the class has such points.
struct ClassFlicker {
    std::string pixels;
    double mean = 0.0;
};

// How the scored frames of a sequence compare, by class of pixel.
struct ClassScores {
    std::vector<FrameScore> frames;
    std::vector<ClassFlicker> flicker;
};

// The scores of a frame against the references that are known.
[[nodiscard]] std::vector<ClassScore> scores_of(const effect::Frame& frame, const ScoredView& truth,
                                                const ClassedView& view);

}  // namespace gloam::experiment
