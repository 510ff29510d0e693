// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "experiment/runner.hpp"

namespace gloam::experiment {

// The names of what a column can show. Errors are root mean square errors against the traced geometry (G).
[[nodiscard]] const std::vector<std::string>& quantities();

struct Text {
    std::string text;  // the tables in Markdown; where a table shows one size, one for each size
    std::map<std::string, std::string> named;  // those with a name alone
    bool missed = false;                       // a target is missed
};

// The experiment's tables. Over several cases errors are arithmetic means, times geometric ones; "-" stands
// for what was not measured.
[[nodiscard]] Text to_text(const Experiment& experiment, const std::vector<SizeResult>& results);

// The time of a candidate while one thing grows from case to case of a kind.
struct Growth {
    std::string kind;
    std::string candidate;
    std::vector<std::pair<double, double>> points;  // the cases' value, and milliseconds
};

// One for each kind and candidate, of the cases with a value.
[[nodiscard]] std::vector<Growth> growths(const Experiment& experiment, const SizeResult& result);

// The median time of a copy in all readings, in milliseconds; NaN without readings.
[[nodiscard]] double copy_ms(const SizeResult& result);

// {"versions", "device", "driver", "experiment", "frames", "scored", "rounds", "rays", "sizes": [{"width",
// "height", "copy_ms", "cases": [{"case", "what", "kind", "half", "value", "target", "results":
// [{"candidate", the quantities but the times, "ms", "copies", "passes": [{"pass", "ms", "least_ms",
// "copies"}], "rounds_ms"}]}]}]}. Times are medians. What was not measured is null.
[[nodiscard]] std::string to_json(const Experiment& experiment, const std::vector<SizeResult>& results,
                                  const gpu::DeviceInfo& device, const std::string& versions);

}  // namespace gloam::experiment
