// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace gloam::cli {

// `gloam demo`: checks the default device, renders three scenes, says where the pictures are.
void add_demo(CLI::App& app, int& status);

}  // namespace gloam::cli
