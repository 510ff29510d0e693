// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <string>

#include "report/check_report.hpp"

namespace gloam::report {

// What the results of many machines are grouped by.
struct DriverGroup {
    std::string vendor;   // "NVIDIA", "AMD", "Mesa", ...; "other" if the names do not tell
    std::string driver;   // the driver's text up to its version: "llvmpipe Mesa"
    std::string version;  // the rest: "22.3.6 (LLVM 15.0.6)"; empty: the text has no number
    std::string api;      // as api_of()

    friend auto operator<=>(const DriverGroup&, const DriverGroup&) = default;
};

[[nodiscard]] DriverGroup group_of(const DeviceSummary& device);

// "llvmpipe Mesa 22.3.6 (LLVM 15.0.6), Vulkan 1.3.230".
[[nodiscard]] std::string name_of(const DriverGroup& group);

}  // namespace gloam::report
