// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "effect/errors.hpp"
#include "effect/history_map.hpp"
#include "effect/settings.hpp"
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

}  // namespace gloam::experiment
