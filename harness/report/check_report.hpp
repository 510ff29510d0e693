// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "check/case.hpp"

namespace gloam::report {

// The device a check ran on, as the report shows it.
struct DeviceSummary {
    std::string name;
    std::string driver;
    std::string type;
    std::string api_version;
    bool preserves_signed_zero_inf_nan = false;
    bool preserves_denormals = false;
    bool flushes_denormals = false;
    bool rounds_to_even = false;
};

// One equation in one variant: what the check found, or why it could not run.
struct CheckRow {
    std::string equation;  // its ID
    std::string variant;
    check::Result result;
    std::string error;  // empty when it ran
    double seconds = 0.0;

    [[nodiscard]] bool passed() const { return error.empty() && result.passed(); }
};

// Everything one device was asked.
struct CheckReport {
    DeviceSummary device;
    std::vector<CheckRow> rows;

    [[nodiscard]] std::size_t failures() const;
};

// Column titles, and one line for each row: ID, function, variant, inputs, worst ULP, worst absolute error,
// verdict.
[[nodiscard]] std::string table_header();
[[nodiscard]] std::string table_line(const CheckRow& row);

// {"device": {...}, "results": [{"equation", "function", "file", "variant", "inputs", "outside", "recorded",
// "max_ulp", "max_abs", "width_fraction", "budget", "classes", "worst", "error"}]}; an array of such objects
// for several devices. width_fraction is the worst error as a fraction of the budget. Infinite numbers are
// the string "inf", NaN is "nan".
[[nodiscard]] std::string to_json(const std::vector<CheckReport>& reports);

// JUnit XML: a test suite for each device, a test case for each row.
[[nodiscard]] std::string to_junit(const std::vector<CheckReport>& reports);

}  // namespace gloam::report
