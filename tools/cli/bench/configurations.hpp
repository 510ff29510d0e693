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

// All configurations that the options select: each scene with each method at each count of samples, then each
// preset; single frames and temporal runs. Throws std::invalid_argument for unknown names, counts out of
// range, and if nothing is selected.
[[nodiscard]] std::vector<MeasuredConfiguration> configurations_of(const BenchmarkOptions& options);

}  // namespace gloam::cli
