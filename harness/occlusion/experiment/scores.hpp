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

// The limit skips the first `limit_first` samples of a sequence and takes the next `limit_samples`.
constexpr std::uint32_t limit_first = 1'024;
constexpr std::uint32_t limit_samples = 4'096;

// The value to which an estimator converges on one view: the mean of its samples 1025 to 5120, without
// rotation. It shares no sample with an effect that has taken at most 1024. The difference between both
// therefore contains the errors of both.
class Limit {
  public:
    // The device must outlive this object. Throws like AmbientOcclusion.
    Limit(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent)
        : effect_(device, passes, extent) {}

    // The limit for each pixel of a view. Throws like AmbientOcclusion.
    [[nodiscard]] std::vector<float> of(const scene::GBuffer& view, const effect::Settings& settings);

  private:
    effect::AmbientOcclusion effect_;
};

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
    effect::Truth geometry;  // (G)
    effect::Truth depth;     // (D)
    effect::Truth limit;
    std::optional<effect::HistoryMap> history;  // from the view before
    std::vector<float> due;  // change of (G) since then at the same surface points; empty: none
};

// Errors of the pixels of one class against one reference, as sums, so that those of frames can be added.
struct ClassScore {
    std::string pixels;        // the class
    std::string against;       // "limit", the depth truth (D) "depth", the geometry truth (G) "geometry"
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
    double most_samples = 0.0;  // that count in a mean
    std::vector<FrameScore> frames;
    std::vector<ClassFlicker> flicker;
};

// The scores of a frame against the references that are known.
[[nodiscard]] std::vector<ClassScore> scores_of(const effect::Frame& frame, const ScoredView& truth,
                                                const ClassedView& view);

}  // namespace gloam::experiment
