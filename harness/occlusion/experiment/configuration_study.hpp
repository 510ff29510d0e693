// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/errors.hpp"
#include "effect/methods.hpp"
#include "effect/pixel_classes.hpp"
#include "effect/settings.hpp"
#include "effect/study/plain_slices.hpp"
#include "experiment/experiment.hpp"
#include "scene/draw.hpp"
#include "scene/truth.hpp"

namespace gloam::experiment {

// The remap of what is displayed with these settings.
[[nodiscard]] effect::Remap remap_of(const effect::Settings& settings);

// The frames of a scene that the benchmark uses, and the number of rays of their truth.
struct BenchmarkFrames {
    backend::Extent extent;
    int frames = 16;  // of a temporal run
    int scored = 8;   // the last ones of these: 1 to frames
    int every = 1;    // of these, from one that counts to the next
    int rays = 256;   // of the truth, for each pixel; 0: there is no truth, and nothing is scored
    std::filesystem::path truth_cache{};  // scene::TruthSettings::cache
    bool depth_truth = true;              // false: only the geometry is traced
    // Of the surface of (D), in radii; as in depth_field().
    double depth_thickness = std::numeric_limits<double>::infinity();
    int repeat = 1;  // runs of a timed frame, whose median time counts
    // Views know how surfaces moved, not only the camera; nullopt: if objects do.
    std::optional<bool> motion{};
    bool still = false;             // every view is the first frame's, and has not moved since the one before
    std::set<Quantity> measures{};  // what is measured besides errors and times
    std::vector<int> shown{};  // for how many frames each view is shown, in all `frames`; empty: for one each
};

// The pixels of each class of a view: "all", with an empty mask; effect::pixel_class_names; where
// BenchmarkFrames ask for them, the places of effect::HardPlaces, "contacts", "thin" and "rim".
using ClassMasks = std::vector<std::pair<std::string, effect::Mask>>;

// The truth of a scored view, and what else its score needs. Empty where it is not asked for.
struct ScoredView {
    effect::Truth geometry;                     // (G)
    effect::Truth depth;                        // (D)
    std::optional<effect::HistoryMap> history;  // from the view before
    std::vector<float> due;  // change of (G) since then at the same surface points; empty: none
};

// The first frames of a scene with the truth of the scored ones. They are rendered and traced once for all
// configurations.
class BenchmarkViews {
  public:
    // Throws like scene::draw() and scene::trace_geometry().
    BenchmarkViews(scene::Scene scene, const BenchmarkFrames& frames,
                   const std::function<void(double)>& progress = {});

    [[nodiscard]] const scene::Scene& scene() const { return scene_; }
    [[nodiscard]] const BenchmarkFrames& frames() const { return frames_; }

    // The frames that count, in their order.
    [[nodiscard]] const std::vector<int>& scored_frames() const { return scored_frames_; }
    [[nodiscard]] int last_scored() const { return scored_frames_.back(); }
    [[nodiscard]] bool is_scored(int frame) const {
        return std::ranges::binary_search(scored_frames_, frame);
    }

    // Whether a frame shows another view than the one before it. The first does.
    [[nodiscard]] bool is_new(int frame) const;

    // A frame with the guard band and the depth layers that the settings ask for.
    [[nodiscard]] const scene::GBuffer& view(int frame, const effect::Settings& settings);
    [[nodiscard]] const ScoredView& scored(int frame) const;

    // Where Quantity::by_class is measured.
    [[nodiscard]] const ClassMasks& classed(int frame) const;

    // The truth of the last scored frame by the method's own weighting and falloff. nullptr for a method that
    // does not estimate occlusion by rays, or that has a falloff of its own.
    [[nodiscard]] const effect::Truth* own_measure(const effect::MethodInfo& method);

  private:
    using Measured = std::pair<scene::Weighting, scene::Falloff>;

    [[nodiscard]] int number(int frame) const { return numbers_.at(static_cast<std::size_t>(frame)); }
    void score(const std::function<void(double)>& progress);
    void classify();
    [[nodiscard]] scene::TruthSettings traced(const Measured& measured) const;
    std::vector<scene::GBuffer>& views_with(double guard, int layers);

    scene::Scene scene_;
    BenchmarkFrames frames_;
    std::vector<int> numbers_;  // of the view that each frame shows
    std::vector<int> scored_frames_;
    std::map<std::pair<double, int>, std::vector<scene::GBuffer>> views_;  // by guard band and layers
    std::map<int, ScoredView> scored_;                                     // by the view's number
    std::vector<ClassMasks> classed_;
    std::map<Measured, effect::Truth> own_;
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

// Times of a frame on the device, in milliseconds.
struct FrameReading {
    std::vector<effect::PassTime> passes;
};

// A frame of many samples, and how it compares with truths.
struct Converged {
    effect::Errors geometry;
    effect::Errors remapped;  // after its best remap
    double similarity = 0.0;
    std::optional<effect::Errors> depth{};
    std::optional<effect::Errors> own{};  // by the method's own measure
};

// Errors of a configuration: RMSE, means over the scored frames.
struct FrameQuality {
    double raw_geometry = 0.0;  // of the estimate against (G)
    double raw_depth = 0.0;     // of the estimate against (D); 0 where that is not traced
    double geometry = 0.0;      // of the displayed image against (G)
    double depth = 0.0;
    double bias = 0.0;                    // mean of the displayed image - (G)
    double similarity = 0.0;              // SSIM of the displayed image and (G), in the last scored frame
    std::optional<double> percentile_99;  // of the magnitude of the displayed image's errors
    std::optional<double> flicker;
    std::optional<double> remapped;           // of the estimate in the last scored frame after its best remap
    std::optional<effect::TileShares> tiles;  // of the last scored frame
    double samples = 0.0;                     // taken for each pixel with geometry, mean
    std::uint64_t memory_bytes = 0;
    std::optional<Converged> converged;
    std::optional<ClassScores> by_class;
    // Of the displayed image and (G), over the scored frames: 128 of the visibility, finer than the eye and
    // the errors of any method.
    std::optional<std::vector<effect::RemapBin>> bins;
};

struct ConfigurationVisit {
    std::optional<FrameQuality> quality;  // in round 0, of views with a truth
    std::vector<FrameReading> readings;
    effect::Frame shown;           // the last scored frame, in round 0
    std::vector<float> converged;  // of single frames, where that is measured, in round 0
};

// Measures configurations of the effect in rounds. Each round visits every configuration once, so that the
// machine's load affects all of them alike.
class ConfigurationStudy {
  public:
    // The device must outlive this object.
    ConfigurationStudy(const backend::vulkan::Device& device, const scene::PassLibrary& passes);

    // Round 0 judges all scored frames and warms up; it does not time single frames. Each later round times a
    // single frame at one of the scored frames, in turn. A temporal run goes through all frames each time and
    // is timed in the scored ones. Settings are for the scene's radius. Throws like AmbientOcclusion.
    [[nodiscard]] ConfigurationVisit visit(BenchmarkViews& views, const effect::Settings& settings,
                                           bool temporal, int round);

  private:
    effect::AmbientOcclusion& effect_for(backend::Extent extent);
    [[nodiscard]] ConfigurationVisit single(BenchmarkViews& views, effect::Settings settings, int round);
    [[nodiscard]] ConfigurationVisit temporal(BenchmarkViews& views, const effect::Settings& settings,
                                              int round);

    const backend::vulkan::Device* device_;
    scene::PassLibrary passes_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, effect::AmbientOcclusion>
        effects_;  // by size of the view
};

// Single frames of the plain loop, measured like the configurations of a ConfigurationStudy. Round 0 judges
// all scored frames. Each later round times them. Throws like PlainSlices::take(), which refuses orthographic
// cameras.
[[nodiscard]] ConfigurationVisit plain_visit(effect::PlainSlices& loop, BenchmarkViews& views, int round);

// (D) as a candidate: its error against (G). Nothing is timed.
[[nodiscard]] ConfigurationVisit depth_truth_of(const BenchmarkViews& views, int round);

// (G) itself, as an image of which nothing is judged.
[[nodiscard]] inline ConfigurationVisit truth_of(const BenchmarkViews& views, int round) {
    if (round > 0 || views.frames().rays == 0) return {};
    return {.shown = {.filtered = views.scored(views.last_scored()).geometry}};
}

}  // namespace gloam::experiment
