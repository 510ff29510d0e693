// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

namespace gloam::cli {

// Adds the subcommand `bench`, a group: each part measures something of its own. `status` receives what a
// part returns.
void add_bench(CLI::App& app, int& status);

}  // namespace gloam::cli
