// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "report/answer_json.hpp"

namespace gloam::cli {

// One check for a worker. The messages between workers and their parent are one line of JSON each:
// report::line_of(), and report::from_line(), which throws std::runtime_error with the missing or invalid
// part.
struct CheckTask {
    std::string equation;  // its ID; or a function of `file`
    std::string variant;
    std::size_t inputs = 0;
    std::uint64_t seed = 0;
    bool coverage = false;
    std::string file;                   // a user's file, with its folder; empty: an equation of the catalogue
    std::vector<std::string> ranges;    // of its parameters: see check::range_from()
    std::vector<std::string> includes;  // its further include roots
};

template <class Io>
void members(Io& io, CheckTask& task) {
    report::each(io, "equation", task.equation, "variant", task.variant, "inputs", task.inputs, "seed",
                 task.seed, "coverage", task.coverage, "file", task.file, "ranges", task.ranges, "includes",
                 task.includes);
}

// A worker's greeting: its device, or all those that it was to list, or why there are none.
struct Greeting {
    std::vector<report::DeviceSummary> devices;
    std::string error;  // empty: there is a device
};

template <class Io>
void members(Io& io, Greeting& greeting) {
    report::each(io, "devices", greeting.devices, "error", greeting.error);
}

}  // namespace gloam::cli
