// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "cli/bench/benchmark_options.hpp"
#include "effect/settings.hpp"
#include "report/benchmark/result.hpp"

namespace gloam::cli {

// A configuration with its settings, lengths for a radius of 1.
struct MeasuredConfiguration {
    report::Configuration configuration;
    effect::Settings settings;
};

// Everything that the options ask for: each scene with each method at each count of samples, then each
// preset; single frames and temporal runs. Throws std::invalid_argument for names that there are not, counts
// out of range, and when nothing is left.
[[nodiscard]] std::vector<MeasuredConfiguration> configurations_of(const BenchmarkOptions& options);

}  // namespace gloam::cli
