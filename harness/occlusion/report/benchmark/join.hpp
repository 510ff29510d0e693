// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "report/benchmark/result.hpp"

namespace gloam::report {

// Joins parts of a benchmark: the rows of one or more runs, the framework of others. Throws
// std::invalid_argument if there is no part, if parts are of different devices, if their rows were measured
// with different settings, and if a configuration is in two parts.
[[nodiscard]] Benchmark joined(std::span<const Benchmark> parts);

}  // namespace gloam::report
