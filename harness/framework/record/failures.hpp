// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "judge/reproduction.hpp"
#include "record/check_report.hpp"

namespace gloam::record {

// An AmberScript (https://github.com/google/amber) that runs the check of one input and expects each output
// in its range, ends included; NaN only if it is allowed. Of several outcomes it expects the hull, and not
// what was found where that is in no outcome's range. No image is `bound`. `comments`: lines at the top. Run
// it with `amber -v 1.2 -t spv1.5 FILE`.
[[nodiscard]] std::string to_amber(const judge::Reproduction& all, const std::vector<std::string>& comments);

// A program in C, on the Vulkan loader alone, that runs the module, and the one before its steps, on the
// device where it failed, or on one that its argument names, and prints each output beside what is allowed.
// Its exit status is 1 if no outcome contains the outputs of the first module, and 2 if it could not run.
// Build it with `cc FILE -lvulkan -lm`. The words of `bound` images are struct sampled of replay/replay.c,
// then texels in their format. `device`: where it failed; empty: on none.
[[nodiscard]] std::string to_c_program(const judge::Reproduction& all,
                                       const std::vector<std::string>& comments, const std::string& device);

// What is needed to reproduce a failure.
struct RunAgain {
    std::string command;   // complete; empty: gloam check with the equation and the variant alone
    std::string versions;  // of gloam and of the compilers; empty: unknown
    bool amber = true;     // there is a script for it
    bool program = true;   // and a program in C
    std::vector<std::string> steps = {};  // the fewest that fail
    std::vector<std::string> rules = {};  // judge::rules_of() its operations
};

// The description of a failing row, complete in itself: what failed where, the smallest input found in
// decimal and hexadecimal, the result, the expected and the allowed values, the device and its driver, and
// how to run it again. `note`: what could not be determined; may be empty.
[[nodiscard]] std::string failure_text(const DeviceSummary& device, const judge::Answer& row,
                                       const std::optional<judge::Sample>& smallest, const std::string& note,
                                       const RunAgain& again = {});

// The word in a shell's syntax, quoted if necessary.
[[nodiscard]] std::string shell_word(const std::string& text);

// Lower-case letters, digits and dashes only: a folder name for a device or an equation. A long one ends in a
// hash.
[[nodiscard]] std::string slug(const std::string& text);

}  // namespace gloam::record
