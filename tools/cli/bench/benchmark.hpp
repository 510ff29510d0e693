// SPDX-License-Identifier: MIT
#pragma once

#include "cli/bench/benchmark_options.hpp"

namespace gloam::cli {

// `gloam bench`: measures (or reads a result file, or compares two), prints the fronts and the answers, and
// writes the requested files. Returns the exit status: 0; 1 if the validation layers reported messages, if no
// configuration is within --budget or --error, or if something got worse and --fail-if-worse is given.
[[nodiscard]] int run_benchmark(const BenchmarkOptions& options);

}  // namespace gloam::cli
