// SPDX-License-Identifier: MIT
#pragma once

#include "cli/bench/benchmark_options.hpp"
#include "report/benchmark/result.hpp"

namespace gloam::cli {

// Prints the best configuration for --budget and for --error, where they were given. False when there is none
// for one of them; the nearest is named then.
[[nodiscard]] bool answer(const report::Benchmark& benchmark, const BenchmarkOptions& options);

}  // namespace gloam::cli
