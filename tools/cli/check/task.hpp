// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "report/check_report.hpp"

namespace gloam::cli {

// One check that a worker is to run.
struct CheckTask {
    std::string equation;  // its ID; or a function of `file`
    std::string variant;
    std::size_t inputs = 0;
    std::uint64_t seed = 0;
    bool coverage = false;
    std::string file;                 // somebody's own, with its folder; empty: an equation of the catalogue
    std::vector<std::string> ranges;  // of its parameters: see check::range_from()
};

// What workers and their parent say to each other, each in one line of JSON. Reading throws
// std::runtime_error that names what is missing or wrong.
[[nodiscard]] std::string to_line(const CheckTask& task);
[[nodiscard]] CheckTask task_from(std::string_view line);

// A worker's greeting: its device (or the number of devices, when it was asked for that only), or why it has
// none.
struct Greeting {
    report::DeviceSummary device;
    std::size_t devices = 0;
    std::string error;  // empty: there is a device
};
[[nodiscard]] std::string to_line(const Greeting& greeting);
[[nodiscard]] Greeting greeting_from(std::string_view line);

}  // namespace gloam::cli
