// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "experiment/runner.hpp"

namespace gloam::experiment {

// The names of what a column can show. Errors are root mean square errors against the traced geometry (G).
[[nodiscard]] const std::vector<std::string>& quantities();

struct Text {
    std::string text;     // the tables in Markdown; where a table shows one size, one for each size
    bool missed = false;  // a target is missed
};

// The experiment's tables. Over several cases errors are arithmetic means, times geometric ones; "-" stands
// for what was not measured.
[[nodiscard]] Text to_text(const Experiment& experiment, const std::vector<SizeResult>& results);

// The median time of a copy in all readings, in milliseconds; NaN without readings.
[[nodiscard]] double copy_ms(const SizeResult& result);

// {"versions", "device", "driver", "experiment", "frames", "scored", "rounds", "rays", "sizes": [{"width",
// "height", "copy_ms", "cases": [{"case", "what", "kind", "half", "target", "results": [{"candidate",
// "errors", "ms", "copies", "passes", "work"}]}]}]}. What was not measured is null.
[[nodiscard]] std::string to_json(const Experiment& experiment, const std::vector<SizeResult>& results,
                                  const gpu::DeviceInfo& device, const std::string& versions);

}  // namespace gloam::experiment
