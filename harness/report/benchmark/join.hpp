// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "report/benchmark/result.hpp"

namespace gloam::report {

// Parts of a benchmark as one: the rows of one or more runs, scaling and framework of others. Throws
// std::invalid_argument for no part, for parts of different devices, for rows measured under different
// circumstances, and for a configuration that is in two parts.
[[nodiscard]] Benchmark joined(std::span<const Benchmark> parts);

}  // namespace gloam::report
