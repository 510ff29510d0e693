// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/bench/bar.hpp"
#include "effect/study/bar_study.hpp"
#include "gpu/device.hpp"
#include "gpu/image.hpp"
#include "report/benchmark/result.hpp"

namespace gloam::cli {

// The result of a scene.
struct BarRow {
    std::string scene;
    effect::Bar bar;

    // Error of the run's displayed image, divided by that of the exact single frame.
    [[nodiscard]] double error_ratio() const;

    // Time of the run, divided by that of the fast single frame measured beside it.
    [[nodiscard]] report::Spread time_ratio() const;

    // Total time of the run, divided by the fast single frame's time without its blur.
    [[nodiscard]] report::Spread time_ratio_to_slices() const;

    // Whether the ratio of error and the median ratio of time are at most 1.
    [[nodiscard]] bool met() const;
};

struct BarReport {
    gpu::DeviceInfo device;
    gpu::Extent extent;
    std::vector<BarRow> rows;
};

// A sentence with the conditions, and a row for each scene, in Markdown.
[[nodiscard]] std::string to_text(const BarReport& report, const BenchBarOptions& options);

[[nodiscard]] std::string to_json(const BarReport& report, const BenchBarOptions& options);

}  // namespace gloam::cli
