// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "report/check_report.hpp"

namespace gloam::report {

// What is needed to reproduce a failure.
struct RunAgain {
    std::string command;   // complete; empty: gloam check with the equation and the variant alone
    std::string versions;  // of gloam and of the compilers; empty: unknown
};

// The description of a failing row, complete in itself: what failed where, the smallest input found in
// decimal and hexadecimal, the result, the expected and the allowed values, the device and its driver, and
// how to run it again. `note`: what could not be determined; may be empty.
[[nodiscard]] std::string failure_text(const DeviceSummary& device, const check::Answer& row,
                                       const std::optional<check::Sample>& smallest, const std::string& note,
                                       const RunAgain& again = {});

// The word in a shell's syntax, quoted if necessary.
[[nodiscard]] std::string shell_word(const std::string& text);

// Lower-case letters, digits and dashes only: a folder name for a device or an equation.
[[nodiscard]] std::string slug(const std::string& text);

}  // namespace gloam::report
