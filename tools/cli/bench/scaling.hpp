// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "cli/bench/benchmark_options.hpp"
#include "gpu/device.hpp"
#include "report/benchmark/result.hpp"
#include "scene/pass_library.hpp"

namespace gloam::cli {

// Growth of the selected methods' times (default: the first method) with pixels, samples, radius, filter and
// objects, with exponents. Throws like effect::study_scaling().
[[nodiscard]] std::vector<report::Growth> measured_scaling(const BenchmarkOptions& options,
                                                           const gpu::Device& device,
                                                           const scene::PassLibrary& passes);

// Throws std::invalid_argument for invalid sizes in --scaling-sizes.
void check_scaling(const BenchmarkOptions& options);

}  // namespace gloam::cli
