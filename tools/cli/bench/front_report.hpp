// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "effect/settings.hpp"
#include "effect/study/plain_slices.hpp"
#include "gpu/device.hpp"
#include "scene/views.hpp"

namespace gloam::cli {

// Single frames of the plain loop, and how often its blur is applied.
struct PlainLoop {
    effect::SliceTaps taps;
    int blurs = 0;
};

// What is measured: the plain loop if there is one, otherwise the settings.
struct FrontRun {
    std::string name;
    std::optional<PlainLoop> plain;
    effect::Settings settings;  // lengths for a radius of 1
    bool sequence = false;      // with its history; otherwise each frame alone
};

// What a run reached on one view.
struct FrontCell {
    double rmse = 0.0;              // of the displayed image against (G), mean over the scored frames
    double copies = 0.0;            // time of a frame, median
    std::optional<double> flicker;  // mean change from frame to frame at the same points
};

// A view's results, one cell for each run.
struct FrontRow {
    scene::ViewInfo view;
    std::vector<FrontCell> cells;
};

// Images of one size.
struct FrontSize {
    gpu::Extent extent;
    std::vector<FrontRow> rows;
};

struct FrontReport {
    gpu::DeviceInfo device;
    std::vector<FrontRun> runs;
    std::vector<FrontSize> sizes;
    int frames = 0;
    int scored = 0;
    int rays = 0;
};

// A run's means over the views of one size: of errors and flicker arithmetic, of times geometric.
[[nodiscard]] FrontCell mean_of(const FrontSize& size, std::size_t run);

// Whether no other run of this size has both a smaller mean error and a smaller mean time.
[[nodiscard]] bool on_front(const FrontSize& size, std::size_t run);

// Tables in Markdown: the means of each run at each size, with the ratio of errors to the first run, then the
// errors by kind of view for each size. The front is printed in bold.
[[nodiscard]] std::string to_text(const FrontReport& report);

[[nodiscard]] std::string to_json(const FrontReport& report);

}  // namespace gloam::cli
