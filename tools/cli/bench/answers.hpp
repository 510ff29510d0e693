// SPDX-License-Identifier: MIT
#pragma once

#include "cli/bench/benchmark_options.hpp"
#include "report/benchmark/result.hpp"

namespace gloam::cli {

// Prints the best configuration for --budget and for --error, if given. Returns false if there is none for
// one of them; then it prints the nearest.
[[nodiscard]] bool answer(const report::Benchmark& benchmark, const BenchmarkOptions& options);

}  // namespace gloam::cli
