// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "catalogue/entry.hpp"
#include "module/compile.hpp"

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
[[nodiscard]] catalogue::Entries equations_named(const std::vector<std::string>& names);

// The numbers of the papers (catalogue::printed_equations()), with their functions.
[[nodiscard]] std::vector<Named> number_names();

// The variant with this name; all variants for "all". Throws std::invalid_argument that lists the names.
[[nodiscard]] std::vector<shader::Variant> select_variants(const std::string& name);

// "gloam 0.2.0, glslang 11.13.0 (generator 10), SPIRV-Tools v2022.4, SPIRV-Cross ...": the versions on which
// a result depends, besides the device and its driver.
[[nodiscard]] std::string versions();

}  // namespace gloam::cli
