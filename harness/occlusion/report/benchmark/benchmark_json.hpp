// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "report/benchmark/result.hpp"

namespace gloam::report {

// {"benchmark": 1, "device", "driver", "width", "height", "frames", "scored", "repeat", "rays", "copy_ms":
// {"median", "low", "high"}, "results": [{"scene", "method", "preset", "samples", "temporal", "readings",
// "gather_ms", "total_ms", "gather_copies", "total_copies", "passes": [{"pass", "ms"}], "quality":
// {"rmse_geometry", "rmse_depth", "rmse_raw_geometry", "rmse_raw_depth", "ssim", "flicker", "samples_taken",
// "memory_bytes"}}], "framework": [{"name", "unit", "value"}]}. Numbers that are not known are "nan".
[[nodiscard]] std::string to_json(const Benchmark& benchmark);

// Reads it. Throws std::runtime_error with the place in the text, what was found and what was expected.
[[nodiscard]] Benchmark benchmark_from_json(std::string_view text);

// A title line, then a line for each configuration; unknown numbers are empty.
[[nodiscard]] std::string to_csv(const Benchmark& benchmark);

}  // namespace gloam::report
