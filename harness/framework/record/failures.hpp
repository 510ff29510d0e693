// SPDX-License-Identifier: MIT
#pragma once

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

// A failure, prepared for a report.
struct FailureBundle {
    judge::Reproduction reproduction = {};
    std::string amber = {};      // to_amber(); empty: there is no script for it
    std::string c_program = {};  // to_c_program(), likewise
    std::string error = {};      // why the other members are empty; empty: no error
};

// The description of a failing row, complete in itself: what failed where, the smallest input found in
// decimal and hexadecimal, the result, the expected and the allowed values, the device and its driver, and
// how to run it again. command: that repeats the check. versions: of gloam and of the compilers.
// program_command: that builds and runs the program in C.
[[nodiscard]] std::string failure_text(const DeviceSummary& device, const judge::Answer& row,
                                       const FailureBundle& bundle, const std::string& command,
                                       const std::string& versions, const std::string& program_command);

// The word in a shell's syntax, quoted if necessary.
[[nodiscard]] std::string shell_word(const std::string& text);

// Lower-case letters, digits and dashes: the folder of a device or an equation. A long one ends in a hash.
[[nodiscard]] std::string slug(const std::string& text);

}  // namespace gloam::record
