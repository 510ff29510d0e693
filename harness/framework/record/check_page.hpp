// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "record/check_report.hpp"
#include "record/page.hpp"

namespace gloam::record {

// A row for each equation: documented error, error on any driver, and measured error of each driver.
[[nodiscard]] Table accuracy_table(const std::vector<CheckReport>& reports);

// Every check of every device, failures first: a row each, with its results and its worst input. There is a
// column for the device if there are several.
[[nodiscard]] Table check_table(const std::vector<CheckReport>& reports);

// The results of `gloam check` as one HTML page: the devices with the number of failed checks, the story of
// each failure, accuracy_table() and check_table(). `notes`: paragraphs below the title, for example
// conflicts between merged files.
[[nodiscard]] std::string to_check_page(const std::vector<CheckReport>& reports,
                                        const std::vector<std::string>& notes = {});

}  // namespace gloam::record
