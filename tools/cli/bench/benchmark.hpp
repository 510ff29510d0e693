// SPDX-License-Identifier: MIT
#pragma once

#include "cli/bench/benchmark_options.hpp"

namespace gloam::cli {

// `gloam bench`: measures (or reads a result file, or compares two), prints the fronts and the answers, and
// writes what was asked for. Returns the exit status: 0; 1 when the validation layers had something to say,
// when no configuration is within --budget or --error, or when something got worse and --fail-if-worse asks
// for it.
[[nodiscard]] int run_benchmark(const BenchmarkOptions& options);

}  // namespace gloam::cli
