// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/errors.hpp"
#include "effect/pixel_classes.hpp"
#include "effect/settings.hpp"
#include "effect/study/copy_clock.hpp"
#include "effect/study/plain_slices.hpp"
#include "scene/rasterize.hpp"
#include "scene/truth.hpp"

namespace gloam::experiment {

// The frames of a scene that the benchmark uses, and the number of rays of their truth.
struct BenchmarkFrames {
    gpu::Extent extent;
    int frames = 16;          // of a temporal run
    int scored = 8;           // the last ones of these: 1 to frames
    int rays = 256;           // of the truth, for each pixel; 0: there is no truth, and nothing is scored
    bool depth_truth = true;  // false: only the geometry is traced
    double depth_thickness =
        std::numeric_limits<double>::infinity();  // of the surface of (D), in radii; as in depth_field()
    int repeat = 1;                               // runs of a timed frame, whose median time counts
    bool motion = true;        // views know how objects moved; otherwise only how the camera did
    bool still = false;        // every view is the first frame's
    bool remap = false;        // the best remap of the last frame is looked for
    std::vector<int> shown{};  // for how many frames each view is shown, in all `frames`; empty: for one each
    std::function<void(scene::GBuffer& view, int number)> edit{};  // changes a view; then no truth is traced
};

// The truth of a scored frame, and what else its score needs.
struct ScoredFrame {
    effect::Truth geometry;  // (G)
    effect::Truth depth;     // (D); empty where it is not traced
    std::optional<effect::HistoryMap> history;
};

// The first frames of a scene with the truth of the scored ones. They are rendered and traced once for all
// configurations.
class BenchmarkViews {
  public:
    // The device must outlive this object. Throws std::invalid_argument for frames out of range, and like
    // scene::rasterize() and scene::trace_geometry().
    BenchmarkViews(const gpu::Device& device, const scene::PassLibrary& passes, scene::Scene scene,
                   const BenchmarkFrames& frames, const scene::TruthCache& cache,
                   const std::function<void(double)>& progress = {});

    [[nodiscard]] const scene::Scene& scene() const { return scene_; }
    [[nodiscard]] const BenchmarkFrames& frames() const { return frames_; }
    [[nodiscard]] int first_scored() const { return frames_.frames - frames_.scored; }

    // Whether a frame shows another view than the one before it. The first does.
    [[nodiscard]] bool is_new(int frame) const;

    // A frame with the guard band and the depth layers that the settings ask for.
    [[nodiscard]] const scene::GBuffer& view(int frame, const effect::Settings& settings);
    [[nodiscard]] const ScoredFrame& scored(int frame) const;

  private:
    const gpu::Device* device_;
    scene::PassLibrary passes_;
    scene::Scene scene_;
    BenchmarkFrames frames_;
    std::map<std::pair<double, int>, std::vector<scene::GBuffer>> views_;  // by guard band and layers
    std::vector<ScoredFrame> scored_;

    std::vector<int> numbers_;  // of the view that each frame shows
    std::vector<scene::GBuffer>& views_with(double guard, int layers);
};

// Times on the device at the same moment, in milliseconds: of a frame, and of a copy.
struct FrameReading {
    std::vector<effect::PassTime> passes;
    double copy_ms = 0.0;
};

// Errors of a configuration: RMSE, means over the scored frames.
struct FrameQuality {
    double raw_geometry = 0.0;  // of the estimate against (G)
    double raw_depth = 0.0;     // of the estimate against (D); 0 where that is not traced
    double geometry = 0.0;      // of the displayed image against (G)
    double depth = 0.0;
    double bias = 0.0;        // mean of the displayed image - (G)
    double similarity = 0.0;  // SSIM of the displayed image and (G), in the last scored frame
    std::optional<double> flicker;
    std::optional<double> remapped;  // of the estimate in the last scored frame after its best remap
    double samples = 0.0;            // taken for each pixel with geometry, mean
    std::uint64_t memory_bytes = 0;
};

struct ConfigurationVisit {
    std::optional<FrameQuality> quality;  // in round 0, of views with a truth
    std::vector<FrameReading> readings;
    effect::Work work;         // of the last frame
    std::vector<float> shown;  // the displayed image of the last frame, in round 0
};

// Measures configurations of the effect in rounds. Each round visits every configuration once, so that the
// machine's load affects all of them alike.
class ConfigurationStudy {
  public:
    // The device must outlive this object. Throws like CopyClock.
    ConfigurationStudy(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent);

    // Round 0 judges all scored frames and warms up; it does not time single frames. Each later round times a
    // single frame at one of the scored frames, in turn. A temporal run goes through all frames each time and
    // is timed in the scored ones. Settings are for the scene's radius. Throws like AmbientOcclusion.
    [[nodiscard]] ConfigurationVisit visit(BenchmarkViews& views, const effect::Settings& settings,
                                           bool temporal, int round);

  private:
    effect::AmbientOcclusion& effect_for(gpu::Extent extent);
    [[nodiscard]] ConfigurationVisit single(BenchmarkViews& views, const effect::Settings& settings,
                                            int round);
    [[nodiscard]] ConfigurationVisit temporal(BenchmarkViews& views, const effect::Settings& settings,
                                              int round);

    const gpu::Device* device_;
    scene::PassLibrary passes_;
    effect::CopyClock clock_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, effect::AmbientOcclusion>
        effects_;  // by size of the view
};

// Single frames of the plain loop, measured like the configurations of a ConfigurationStudy.
class PlainRun {
  public:
    // `blurs`: times that the plain blur is applied, >= 0. Throws like PlainSlices.
    PlainRun(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent,
             effect::SliceTaps taps, int blurs);

    // Round 0 judges all scored frames. Each later round times them, each beside a copy. Throws like
    // PlainSlices::take(), which refuses orthographic cameras.
    [[nodiscard]] ConfigurationVisit visit(BenchmarkViews& views, effect::CopyClock& clock, int round);

  private:
    effect::PlainSlices slices_;
};

}  // namespace gloam::experiment
