// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "report/check_report.hpp"

namespace gloam::report {

// What a failing row is about, for a person who has only this text: what failed where, the smallest input
// found in decimal and hexadecimal, what came out, what was wanted and allowed, the device and its driver,
// and how to run it again. `note` says what could not be found out; may be empty.
[[nodiscard]] std::string failure_text(const DeviceSummary& device, const CheckRow& row,
                                       const std::optional<WorstInput>& smallest, const std::string& note);

// Lower-case letters, digits and dashes only: for a folder that is named after a device or an equation.
[[nodiscard]] std::string slug(const std::string& text);

}  // namespace gloam::report
