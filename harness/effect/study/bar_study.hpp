// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/study/benchmark_views.hpp"

namespace gloam::effect {

// A temporal run, and the single frames that it is compared with; settings as for the scene's radius.
struct BarSettings {
    Settings temporal;
    Settings exact;  // a single frame, whose error the run is not to exceed
    Settings fast;   // a single frame, whose time the run is not to exceed
};

// RMSE against (G), means over the scored frames.
struct BarError {
    double raw = 0.0;    // of the estimate
    double shown = 0.0;  // of what is shown
};

// What one frame takes on the device, all passes, milliseconds; one after the other.
struct BarReading {
    double temporal_ms = 0.0;
    double temporal_gather_ms = 0.0;  // of it, the pass that takes samples
    double fast_ms = 0.0;
    double fast_gather_ms = 0.0;  // likewise
};

struct Bar {
    BarError temporal;
    BarError exact;
    BarError fast;
    std::optional<double> flicker;  // of the temporal run: mean change from frame to frame at the same points
    std::vector<BarReading> readings;  // of the scored frames, in all rounds
    std::vector<double> exact_ms;      // of the scored frames, once
};

// Runs through the frames `rounds` times (>= 1). In every scored frame, the run is advanced by one and the
// fast single frame is taken, in turn first and last, so that the machine's load affects both alike. The
// exact one is taken only in the first round. A few frames run before the first one timed, because drivers
// compile at the first dispatch. Throws std::invalid_argument for no round, and like AmbientOcclusion.
[[nodiscard]] Bar study_bar(const gpu::Device& device, const scene::PassLibrary& passes,
                            BenchmarkViews& views, const BarSettings& settings, int rounds,
                            const std::function<void(double)>& progress = {});

}  // namespace gloam::effect
