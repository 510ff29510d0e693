// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/benchmark/result.hpp"

namespace gloam::report {

// The benchmark as a Markdown page: how it was measured, the fronts over all scenes and of each, each method
// at its most exact, and the framework if it was measured. `images`: path from the page to the SVG
// files of plots_of().
[[nodiscard]] std::string to_benchmark_page(const Benchmark& benchmark, const std::string& images);

}  // namespace gloam::report
