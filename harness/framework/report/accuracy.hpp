// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "report/check_report.hpp"
#include "report/table.hpp"

namespace gloam::report {

// The largest measured error of a driver, over the variants that are judged by the documented error.
struct MeasuredError {
    double fraction = 0.0;  // of the documented error
    std::string variant;    // the variant with the largest error
};

// The documented, the guaranteed and the measured accuracy of an equation.
struct EquationAccuracy {
    std::string equation;
    std::string documented;  // "4 ulp"; empty where Vulkan's rules alone judge
    std::optional<check::Guarantee>
        any_driver;     // what the rules guarantee on any driver; nullopt without a strict run
    double open = 0.0;  // share of the inputs for which the rules permit every result
    std::vector<std::optional<MeasuredError>> measured;  // for each report; nullopt if the rules judge
};

// The accuracy of every equation, in the order of the rows; one report for each driver.
[[nodiscard]] std::vector<EquationAccuracy> accuracies(const std::vector<CheckReport>& reports);

// Markdown tables: how many equations use which part of their documented error on each driver, what the rules
// guarantee, and the ten equations that use the largest part. Then how many checks passed in each variant,
// and every check that failed.
[[nodiscard]] std::string to_accuracy_markdown(const std::vector<CheckReport>& reports);

// A row for each equation: documented error, error on any driver, and measured error of each driver.
[[nodiscard]] Table accuracy_table(const std::vector<CheckReport>& reports);

}  // namespace gloam::report
