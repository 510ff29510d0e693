// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "report/benchmark/result.hpp"
#include "report/plot.hpp"

namespace gloam::report {

// Error against time: RMSE of the displayed image and (G) against the copies of all passes, both logarithmic.
// The front is a staircase with named points. Methods with a point on it are coloured, all others are grey.
// Throws std::invalid_argument for a scene without a row.
[[nodiscard]] Plot error_against_time(const Benchmark& benchmark, const std::string& scene);

// The same over all scenes: geometric means; the error is relative to the least of each scene.
[[nodiscard]] Plot error_against_time(const Benchmark& benchmark);

// Every plot of a benchmark, with the name of its file without suffix: "columns", "overall".
[[nodiscard]] std::vector<std::pair<std::string, Plot>> plots_of(const Benchmark& benchmark);

}  // namespace gloam::report
