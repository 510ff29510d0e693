// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace gloam::cli {

// A figure of the shader-test framework itself.
struct Figure {
    std::string name;
    std::string unit;
    double value = 0.0;
};

// Costs of the framework itself on a device: evaluations per second of a cheap and an expensive equation,
// also as a fraction of the rate of a bare dispatch that copies the same bytes, timed in turn; opening the
// device; and a kernel and its first result, without and with caches. Medians of `repeat` rounds. Throws like
// check::Lab.
[[nodiscard]] std::vector<Figure> framework_figures(const std::string& device, int repeat,
                                                    const std::function<void(double)>& progress);

}  // namespace gloam::cli
