// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/study/benchmark_views.hpp"
#include "effect/study/copy_clock.hpp"

namespace gloam::effect {

// The settings in which a method is measured, lengths for a radius of 1: those of the preset `paper` for
// single frames, of `moving` for temporal runs (where the mean holds at least two frames), with `samples` for
// every pixel in every frame. Throws like with_method() and validate().
[[nodiscard]] Settings measured_settings(const std::string& method, std::uint32_t samples, bool temporal);

// A frame's time on the device, and a copy's at the same moment; milliseconds.
struct FrameReading {
    std::vector<PassTime> passes;
    double copy_ms = 0.0;
};

// How near a configuration comes to the truth: RMSE, means over the scored frames.
struct FrameQuality {
    double raw_geometry = 0.0;  // of the estimate against (G)
    double raw_depth = 0.0;     // against (D)
    double geometry = 0.0;      // of what is shown
    double depth = 0.0;
    double similarity = 0.0;  // SSIM of what is shown and (G), in the last scored frame
    std::optional<double> flicker;
    double samples = 0.0;  // taken for each pixel with geometry
    std::uint64_t memory_bytes = 0;
};

struct ConfigurationVisit {
    std::optional<FrameQuality> quality;  // in round 0
    std::vector<FrameReading> readings;
};

// Measures configurations of the effect in rounds. In each round every configuration is visited once, so
// that the machine's load affects all of them alike.
class ConfigurationStudy {
  public:
    // The device must outlive this. Throws like CopyClock.
    ConfigurationStudy(const gpu::Device& device, const scene::PassLibrary& passes, gpu::Extent extent);

    // Whether a configuration is to be visited in a round. A temporal run gives as many readings at once as
    // frames are scored, and is visited again after as many rounds.
    [[nodiscard]] static bool due(bool temporal, int round, int scored);

    // Round 0 judges all scored frames and warms up: a single frame is not timed in it. In each round from 1
    // on one of the scored frames is timed, in turn. A temporal run goes through all frames each time and is
    // timed in the scored ones. Settings as for the scene's radius. Throws like AmbientOcclusion.
    [[nodiscard]] ConfigurationVisit visit(BenchmarkViews& views, const Settings& settings, bool temporal,
                                           int round);

  private:
    AmbientOcclusion& effect_for(gpu::Extent extent);
    [[nodiscard]] ConfigurationVisit single(BenchmarkViews& views, const Settings& settings, int round);
    [[nodiscard]] ConfigurationVisit temporal(BenchmarkViews& views, const Settings& settings, int round);

    const gpu::Device* device_;
    scene::PassLibrary passes_;
    CopyClock clock_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, AmbientOcclusion> effects_;  // by size of the view
};

}  // namespace gloam::effect
