// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "effect/ambient_occlusion.hpp"
#include "effect/study/benchmark_views.hpp"
#include "effect/study/plain_slices.hpp"

namespace gloam::effect {

// A temporal run, and the single frames of plain slices with which it is compared.
struct BarSettings {
    Settings temporal;                         // for the scene's radius
    SliceTaps exact{.slices = 9, .steps = 3};  // the run's error must not exceed its error
    SliceTaps fast{.slices = 1, .steps = 2};   // the run's time must not exceed its time
};

// RMSE against (G), means over the scored frames.
struct BarError {
    double raw = 0.0;    // of the estimate
    double shown = 0.0;  // of the displayed image; of plain slices after their blur
};

// Times of one frame on the device, all passes, in milliseconds, measured one after another.
struct BarReading {
    double temporal_ms = 0.0;
    double temporal_gather_ms = 0.0;  // the part of the sampling pass
    double fast_ms = 0.0;
    double fast_slices_ms = 0.0;  // the part of the slices: all but the blur
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
// fast single frame is computed, in alternating order, so that the machine's load affects both alike. The
// exact frame is computed in the first round only. A few untimed frames run first, because drivers compile at
// the first dispatch. Throws std::invalid_argument if rounds < 1, and like AmbientOcclusion and PlainSlices.
[[nodiscard]] Bar study_bar(const gpu::Device& device, const scene::PassLibrary& passes,
                            BenchmarkViews& views, const BarSettings& settings, int rounds,
                            const std::function<void(double)>& progress = {});

}  // namespace gloam::effect
