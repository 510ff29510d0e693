// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/benchmark/result.hpp"

namespace gloam::report {

// A configuration in two runs: what is new over what is old.
struct Change {
    Configuration configuration;
    Spread time;          // ratio of the copies of all passes; low and high: what the quartiles allow
    double error = 1.0;   // ratio of the RMSE of what is shown against (G)
    bool slower = false;  // the fast quarter is slower than the slow quarter was
    bool faster = false;  // the other way round
    bool worse = false;   // the RMSE rose by a ten-thousandth or more: it has no spread of its own
    bool better = false;
};

struct Comparison {
    std::vector<Change> changes;  // of the configurations that both have, in the order of the new
    double time = 1.0;            // geometric mean of the ratios
    double error = 1.0;
    std::vector<std::string> only_old;  // keys
    std::vector<std::string> only_new;
    std::vector<std::string> warnings;  // what makes the runs hard to compare: another device, another size

    [[nodiscard]] bool got_worse() const;  // anything slower or worse
};

[[nodiscard]] Comparison compared(const Benchmark& before, const Benchmark& after);

// Lines for people: warnings, means, what got worse and what got better, with ratios and their spread.
[[nodiscard]] std::string to_text(const Comparison& comparison);

}  // namespace gloam::report
