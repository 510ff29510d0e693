// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/bench/views.hpp"
#include "effect/study/configuration_study.hpp"
#include "gpu/device.hpp"
#include "scene/views.hpp"

namespace gloam::cli {

// A preset as it is measured: alone in each frame, or in sequence.
struct ViewCandidate {
    std::string name;  // "PRESET, single" or "PRESET, sequence"
    effect::Settings settings;
    bool sequence = false;
};

// What a candidate reached on one view.
struct ViewCell {
    effect::FrameQuality quality;
    std::optional<double> copies;  // time of a frame, median; nullopt if nothing was timed
};

// A view's results: one cell for each candidate.
struct ViewRow {
    scene::ViewInfo view;
    std::optional<double> depth_truth;  // RMSE of (D) against (G), mean over the scored frames
    std::vector<ViewCell> cells;
};

struct ViewsReport {
    gpu::DeviceInfo device;
    gpu::Extent extent;
    std::vector<ViewCandidate> candidates;
    std::vector<ViewRow> rows;
};

// Tables in Markdown: the means of each half with the ratio to the first candidate, then those of each kind,
// then a row for each view.
[[nodiscard]] std::string to_text(const ViewsReport& report, const BenchViewsOptions& options);

[[nodiscard]] std::string to_json(const ViewsReport& report, const BenchViewsOptions& options);

}  // namespace gloam::cli
