// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/check_report.hpp"

namespace gloam::report {

// The accuracy of every equation as a Markdown page: what is documented, what Vulkan's rules leave any
// conforming driver (from rows whose verdict is the rules), and what each driver was measured at in each
// variant. Equations and variants in the order of the rows; one report for each driver.
[[nodiscard]] std::string to_accuracy_markdown(const std::vector<CheckReport>& reports);

}  // namespace gloam::report
