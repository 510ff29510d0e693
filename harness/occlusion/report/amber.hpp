// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "numeric/interval.hpp"

namespace gloam::report {

// One dispatch of a generated kernel for a single input, with all that an AmberScript file needs to repeat
// it.
struct KernelReplay {
    std::vector<std::string> comments;  // lines at the top: what, where, how to run
    std::string assembly;               // SPIR-V 1.5
    std::vector<std::uint32_t> inputs;
    bool specialized = false;  // the inputs are also specialization constants, counted from 0
    struct Image {
        std::string name;
        std::vector<std::uint32_t> words;
    };
    std::vector<Image> images;  // in the order of their bindings
    struct Output {
        bool is_float = true;                  // false: compared as words
        std::vector<numeric::Bounds> allowed;  // one range, or none: not judged
        std::string comment;
    };
    std::vector<Output> outputs;
};

// An AmberScript (https://github.com/google/amber) that runs the kernel and expects each output in its range,
// ends included; NaN only if it is allowed. Run it with `amber -v 1.2 -t spv1.5 FILE`.
[[nodiscard]] std::string to_amber(const KernelReplay& replay);

}  // namespace gloam::report
