// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gloam::cli {

// The arguments of one call of gloam. One of them holds {result}, which stands for the file or the folder
// that the call writes.
using WorkItem = std::vector<std::string>;

// Work for many machines: any of them may run any item, in any order.
struct WorkList {
    std::vector<WorkItem> items;

    // The name of an item's result, from its content and the versions: lists that share an item share its
    // result.
    [[nodiscard]] static std::string key_of(const WorkItem& item);
};

// One item for each combination of values, the last name's values first. each: "NAME=VALUES", where VALUES is
// LOW..HIGH, or texts between commas, or @FILE with one on each line. {NAME} in an argument stands for the
// value. Throws std::invalid_argument with what is wrong, and for more than 1,000,000 items.
[[nodiscard]] WorkList work_list_of(const std::vector<std::string>& each, const WorkItem& arguments);

// A line with the versions, the number of items and a hash of all items; then a line of JSON for each.
[[nodiscard]] std::string to_text(const WorkList& list);

// Reads such a file. Throws std::runtime_error with its name for one that is no list, was changed after it
// was made, or was made by other versions.
[[nodiscard]] WorkList read_work_list(const std::filesystem::path& file);

// The {result} of an item replaced.
[[nodiscard]] WorkItem with_result(WorkItem item, const std::string& result);

}  // namespace gloam::cli
