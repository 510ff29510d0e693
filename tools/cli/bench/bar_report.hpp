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

// What was found in a scene.
struct BarRow {
    std::string scene;
    effect::Bar bar;

    // Of the error of what the run shows to that of the exact single frame.
    [[nodiscard]] double error_ratio() const;

    // Of the run's time to the fast single frame's beside it.
    [[nodiscard]] report::Spread time_ratio() const;

    // Of the run's whole time to what the fast single frame takes for its samples alone, without its filter.
    [[nodiscard]] report::Spread time_ratio_to_gather() const;

    // The ratios of error and time at most 1, the time by its median.
    [[nodiscard]] bool met() const;
};

struct BarReport {
    gpu::DeviceInfo device;
    gpu::Extent extent;
    std::vector<BarRow> rows;
};

// A sentence of circumstances and a row for each scene, Markdown.
[[nodiscard]] std::string to_text(const BarReport& report, const BenchBarOptions& options);

[[nodiscard]] std::string to_json(const BarReport& report, const BenchBarOptions& options);

}  // namespace gloam::cli
