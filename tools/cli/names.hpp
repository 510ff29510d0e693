// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace gloam::cli {

// A name that the command line accepts, and its meaning.
struct Named {
    std::string name;
    std::string description;
};

// Names for `gloam render`.
[[nodiscard]] std::vector<Named> method_names();
[[nodiscard]] std::vector<Named> preset_names();
[[nodiscard]] std::vector<Named> setting_names();  // with value, unit and range
[[nodiscard]] std::vector<Named> scene_names();
[[nodiscard]] std::vector<Named> view_names();  // of `gloam bench views` and `gloam tune`, with their halves

}  // namespace gloam::cli
