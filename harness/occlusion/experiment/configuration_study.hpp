// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/study/copy_clock.hpp"
#include "effect/study/plain_slices.hpp"
#include "experiment/benchmark_views.hpp"

namespace gloam::experiment {

// The settings with which a method is measured; lengths are for a radius of 1. Single frames use the preset
// `paper`, temporal runs use `moving`, with a mean over at least two frames. Every pixel takes `samples`
// samples in every frame. Throws like with_method() and validate().
[[nodiscard]] effect::Settings measured_settings(const std::string& method, std::uint32_t samples,
                                                 bool temporal);

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

    // Whether a configuration is visited in a round. One visit of a temporal run yields a reading for each
    // scored frame, so its next visit is that number of rounds later.
    [[nodiscard]] static bool due(bool temporal, int round, int scored);

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
