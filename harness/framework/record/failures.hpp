// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "numeric/interval.hpp"
#include "record/check_report.hpp"

namespace gloam::record {

// One dispatch of a generated kernel for a single input, with all that an AmberScript file needs to repeat
// it.
struct KernelReplay {
    std::vector<std::string> comments;  // lines at the top: what, where, how to run
    std::string device;                 // where it failed; empty: on none
    std::string assembly;               // SPIR-V 1.5
    std::vector<std::uint32_t> inputs;
    bool specialized = false;  // the inputs are also specialization constants, counted from 0
    struct Image {
        std::string name;
        std::vector<std::uint32_t> words;
        bool sampled = false;  // no buffer: struct sampled of replay/replay.c, then texels in its format
    };
    std::vector<Image> images;  // in the order of their bindings
    struct Output {
        bool is_float = true;     // false: compared as words
        std::uint32_t found = 0;  // the word that failed, if the outputs are judged
        std::string comment;
    };
    std::vector<Output> outputs;
    std::vector<check::Sample::Outcome>
        outcomes;  // the outputs lie in one of them; none: they are not judged
};

// An AmberScript (https://github.com/google/amber) that runs the kernel and expects each output in its range,
// ends included; NaN only if it is allowed. Of several outcomes it expects the hull, and not what was found
// where that is in no outcome's range. Run it with `amber -v 1.2 -t spv1.5 FILE`.
[[nodiscard]] std::string to_amber(const KernelReplay& replay);

struct ReplayedModule {
    std::string name;  // letters, digits and blanks
    std::vector<std::uint32_t> words;
};

// A program in C, on the Vulkan loader alone, that runs these modules on the device where it failed, or on
// one that its argument names, and prints each output beside what is allowed. Its exit status is 1 if no
// outcome contains the outputs of the first module, and 2 if it could not run. Build it with `cc FILE
// -lvulkan -lm`.
[[nodiscard]] std::string to_c_program(const KernelReplay& replay,
                                       const std::vector<ReplayedModule>& modules);

// What is needed to reproduce a failure.
struct RunAgain {
    std::string command;   // complete; empty: gloam check with the equation and the variant alone
    std::string versions;  // of gloam and of the compilers; empty: unknown
    bool amber = true;     // there is a script for it
    bool program = true;   // and a program in C
    std::vector<std::string> steps = {};  // the fewest that fail
    std::vector<std::string> rules = {};  // check::rules_of() its operations
};

// The description of a failing row, complete in itself: what failed where, the smallest input found in
// decimal and hexadecimal, the result, the expected and the allowed values, the device and its driver, and
// how to run it again. `note`: what could not be determined; may be empty.
[[nodiscard]] std::string failure_text(const DeviceSummary& device, const check::Answer& row,
                                       const std::optional<check::Sample>& smallest, const std::string& note,
                                       const RunAgain& again = {});

// The word in a shell's syntax, quoted if necessary.
[[nodiscard]] std::string shell_word(const std::string& text);

// Lower-case letters, digits and dashes only: a folder name for a device or an equation. A long one ends in a
// hash.
[[nodiscard]] std::string slug(const std::string& text);

}  // namespace gloam::record
