// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "report/benchmark/result.hpp"

namespace gloam::report {

// The benchmark as a Markdown page: how it was measured, the fronts over all scenes and of each, each
// method at its most exact, scaling and framework where they were measured. `images`: where the plots of
// plots_of() lie as SVG, seen from the page.
[[nodiscard]] std::string to_benchmark_page(const Benchmark& benchmark, const std::string& images);

}  // namespace gloam::report
