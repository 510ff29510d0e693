// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gloam::stress {

// One measured number of a stress run, and the largest value that the documentation allows it.
struct Row {
    std::string run;                // the run that measured it, "long-run"
    std::string varied;             // what was varied: "k 32, w_max 500, float16"
    std::string quantity;           // what was measured, with its unit: "farthest from the exact mean"
    double measured = 0.0;          // NaN only where the quantity does not exist
    std::optional<double> bound{};  // nothing: measured for the documentation only, promised nowhere

    // Written so that NaN breaks a bound.
    [[nodiscard]] bool passed() const { return !bound || measured <= *bound; }
};

using Rows = std::vector<Row>;

inline void append(Rows& rows, const Rows& more) {
    rows.insert(rows.end(), more.begin(), more.end());
}

}  // namespace gloam::stress
