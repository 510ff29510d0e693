// SPDX-License-Identifier: MIT
#pragma once

#include "cli/bench/benchmark_options.hpp"
#include "gpu/device.hpp"
#include "report/benchmark/result.hpp"
#include "scene/pass_library.hpp"

namespace gloam::cli {

// Measures every configuration that the options ask for, in rounds over all of them, and keeps what was
// measured in OUT/journal.jsonl as it comes, where there is such a folder. With --resume only what is not
// there yet is measured. Throws for bad options, a device without timestamps, and what cannot be written.
[[nodiscard]] report::Benchmark measured_benchmark(const BenchmarkOptions& options, const gpu::Device& device,
                                                   const scene::PassLibrary& passes);

}  // namespace gloam::cli
