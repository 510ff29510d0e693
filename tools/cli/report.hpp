// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds the subcommand that merges the JSON of `gloam check` from many machines. `status` receives 0, or 1 if
// there is a failure.
void add_report(CLI::App& app, int& status);

}  // namespace gloam::cli
