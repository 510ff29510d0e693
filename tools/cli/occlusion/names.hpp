// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalogue/entry.hpp"
#include "cli/framework/cost.hpp"

namespace gloam::cli {

// A name that the command line accepts, and its meaning.
struct Named {
    std::string name;
    std::string description;
};

// Names for `gloam render`.
[[nodiscard]] std::vector<Named> method_names();
[[nodiscard]] std::vector<Named> preset_names();   // with error and time
[[nodiscard]] std::vector<Named> setting_names();  // with value, unit and range
[[nodiscard]] std::vector<Named> scene_names();
[[nodiscard]] std::vector<Named> view_names();  // of `gloam bench views`, with their halves

// The equations that names stand for (catalogue::find()), those of all commands. What a number of a paper
// that has no function of its own stands for is said on standard error. Throws std::invalid_argument.
[[nodiscard]] catalogue::Entries entries_named(const std::vector<std::string>& names);
[[nodiscard]] std::vector<check::Question> equations_named(const std::vector<std::string>& names);

// The numbers of the papers (catalogue::printed_equations()), with their functions.
[[nodiscard]] std::vector<Named> number_names();

// The passes of a frame of a preset, with NAME=VALUE set; it takes depth and normals as most engines store
// them.
[[nodiscard]] PresetFrame frame_of(const std::string& preset, const std::vector<std::string>& set,
                                   std::optional<double> tiles);

}  // namespace gloam::cli
