// SPDX-License-Identifier: MIT
#pragma once

#include "cli/bench/benchmark_options.hpp"
#include "gpu/device.hpp"
#include "report/benchmark/result.hpp"
#include "scene/pass_library.hpp"

namespace gloam::cli {

// Measures every selected configuration in rounds, and writes the results to OUT/journal.jsonl as they come,
// if --out is given. With --resume only what the journal lacks is measured. Throws for invalid options, a
// device without timestamps, and files that cannot be written.
[[nodiscard]] report::Benchmark measured_benchmark(const BenchmarkOptions& options, const gpu::Device& device,
                                                   const scene::PassLibrary& passes);

}  // namespace gloam::cli
