// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace gloam::effect {

// A number that a search may change.
struct SearchRange {
    std::string name;
    double least = 0.0;
    double most = 1.0;
    bool whole = false;
    bool logarithmic = false;  // steps are factors; needs least > 0
};

// An evaluated point.
struct SearchPoint {
    std::vector<double> at;  // a number for each range
    double value = 0.0;
    bool improves = false;  // it was the best so far
};

struct SearchOutcome {
    SearchPoint best;
    std::vector<SearchPoint> points;  // in the order of their evaluation, the start first
};

// Throws std::invalid_argument that names the first range that is empty, not finite, or logarithmic without
// least > 0.
void validate(const std::vector<SearchRange>& ranges);

// A coordinate pattern search for the least value. Steps begin at a quarter of each range. In turn, each
// parameter is moved by its step up and then down, and a point that is better is kept. A round without a gain
// halves the steps. It ends when the steps are below 1/64 of the ranges, or after `evaluations` (>= 1)
// points. No point is evaluated twice. start: limited to the ranges. Throws like validate(), and whatever
// `value_at` throws.
[[nodiscard]] SearchOutcome pattern_search(const std::vector<SearchRange>& ranges,
                                           const std::vector<double>& start, int evaluations,
                                           const std::function<double(const std::vector<double>&)>& value_at);

}  // namespace gloam::effect
