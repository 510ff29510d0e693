// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cost/cost.hpp"
#include "subject/lab.hpp"

namespace gloam::cli {

// A pass of a frame, as `gloam cost` counts it.
struct FramePass {
    std::string name;
    module::Spirv module;
    std::vector<backend::Constant> constants;
    double pixels = 1.0;  // of the view, that an invocation makes
    double share = 1.0;   // of the view, that the pass runs on
    double groups = 0.0;  // if it ran on all
    double bytes = 0.0;   // that it then reads and writes, a pixel of the view
};

struct PresetFrame {
    std::vector<FramePass> passes;
    double memory = 0.0;  // bytes of its images and buffers beside those of the engine
};

// The kernel that `gloam check` makes of a function, but for what it declares of NaN: what is counted.
[[nodiscard]] module::Spirv cost_kernel(const subject::Lab& lab, const std::string& file,
                                        const std::string& function, const subject::Signature& signature);

}  // namespace gloam::cli
