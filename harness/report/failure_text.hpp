// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "report/check_report.hpp"

namespace gloam::report {

// What it takes to see a failure again.
struct RunAgain {
    std::string command;   // complete; empty: gloam check with the equation and the variant alone
    std::string versions;  // of gloam and of the compilers; empty: not known
};

// What a failing row is about, for a person who has only this text: what failed where, the smallest input
// found in decimal and hexadecimal, what came out, what was wanted and allowed, the device and its driver,
// and how to run it again. `note` says what could not be found out; may be empty.
[[nodiscard]] std::string failure_text(const DeviceSummary& device, const check::Answer& row,
                                       const std::optional<check::Sample>& smallest, const std::string& note,
                                       const RunAgain& again = {});

// The word as a shell takes it, quoted where it has to be.
[[nodiscard]] std::string shell_word(const std::string& text);

// Lower-case letters, digits and dashes only: for a folder that is named after a device or an equation.
[[nodiscard]] std::string slug(const std::string& text);

}  // namespace gloam::report
