// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace gloam::cli {

// A name that the command line takes, and what it stands for.
struct Named {
    std::string name;
    std::string description;
};

// `gloam list [KIND]`: equations, methods, presets, scenes, variants.
void add_list(CLI::App& app);

}  // namespace gloam::cli
