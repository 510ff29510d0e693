// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "cli/bench/benchmark_options.hpp"
#include "gpu/device.hpp"
#include "report/benchmark/result.hpp"
#include "scene/pass_library.hpp"

namespace gloam::cli {

// How the time of the methods asked for (the first of all where none is) grows with pixels, samples, radius,
// filter and objects, with its exponents. Throws like effect::study_scaling().
[[nodiscard]] std::vector<report::Growth> measured_scaling(const BenchmarkOptions& options,
                                                           const gpu::Device& device,
                                                           const scene::PassLibrary& passes);

// Throws std::invalid_argument for sizes of --scaling-sizes that are none.
void check_scaling(const BenchmarkOptions& options);

}  // namespace gloam::cli
