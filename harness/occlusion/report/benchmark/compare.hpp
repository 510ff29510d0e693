// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/benchmark/result.hpp"

namespace gloam::report {

// A configuration in two runs: ratios of new to old.
struct Change {
    Configuration configuration;
    Spread time;          // ratio of the copies of all passes; low and high from the quartiles
    double error = 1.0;   // ratio of the RMSE of the displayed image against (G)
    bool slower = false;  // the new lower quartile is above the old upper quartile
    bool faster = false;  // the new upper quartile is below the old lower quartile
    bool worse = false;   // the RMSE rose by a ten-thousandth or more; it has no spread
    bool better = false;
};

struct Comparison {
    std::vector<Change> changes;  // of the configurations in both runs, in the order of the new run
    double time = 1.0;            // geometric mean of the ratios
    double error = 1.0;
    std::vector<std::string> only_old;  // keys
    std::vector<std::string> only_new;
    std::vector<std::string> warnings;  // reasons against a comparison: another device, another size

    [[nodiscard]] bool got_worse() const;  // anything slower or worse
};

[[nodiscard]] Comparison compared(const Benchmark& before, const Benchmark& after);

// Text for people: warnings, means, what got worse and what got better, with ratios and their spread.
[[nodiscard]] std::string to_text(const Comparison& comparison);

}  // namespace gloam::report
