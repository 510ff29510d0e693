// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/check_report.hpp"
#include "report/page.hpp"

namespace gloam::report {

// The largest error that a driver was measured at, over the variants that the documented error judges.
struct MeasuredError {
    double fraction = 0.0;  // of the documented error
    std::string variant;    // the one with the largest
};

// How accurate an equation is documented to be, may be, and was.
struct EquationAccuracy {
    std::string equation;
    std::string documented;  // "4 ulp"; empty where Vulkan's rules alone judge
    std::optional<check::Guarantee>
        any_driver;     // what the rules leave any driver; nothing without a strict run
    double open = 0.0;  // share of the inputs for which the rules permit anything
    std::vector<std::optional<MeasuredError>> measured;  // for each report; nothing where the rules judge
};

// Of every equation, in the order of the rows; one report for each driver.
[[nodiscard]] std::vector<EquationAccuracy> accuracies(const std::vector<CheckReport>& reports);

// Tables of Markdown: how many equations use which part of their documented error on each driver, what the
// rules leave, the ten equations that use most, and every check that failed.
[[nodiscard]] std::string to_accuracy_markdown(const std::vector<CheckReport>& reports);

// A row for each equation: documented, any driver, and each driver that was measured.
[[nodiscard]] PageTable accuracy_table(const std::vector<CheckReport>& reports);

}  // namespace gloam::report
