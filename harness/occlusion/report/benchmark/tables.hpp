// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/benchmark/result.hpp"

namespace gloam::report {

// Markdown tables that the terminal and the page share. RMSE are against (G) and (D), "raw" before the
// filter; times are medians.

// The front of a scene: choice, copies and milliseconds of the gather and of all passes, samples taken, RMSE,
// SSIM, flicker, memory.
[[nodiscard]] std::string scene_front_table(const Benchmark& benchmark, const std::string& scene);

// The row with the least RMSE (G) of each method and preset, single and temporal, in the same columns; rows
// on the front are bold.
[[nodiscard]] std::string best_table(const Benchmark& benchmark, const std::string& scene);

// The front over all scenes: choice, copies, milliseconds, error relative to each scene's best, mean error.
[[nodiscard]] std::string overall_table(const Benchmark& benchmark);

// The presets over all scenes, and for each the point of the front that dominates it. Empty without presets.
[[nodiscard]] std::string presets_table(const Benchmark& benchmark);

// Figures of the framework; empty without figures.
[[nodiscard]] std::string framework_table(const Benchmark& benchmark);

}  // namespace gloam::report
