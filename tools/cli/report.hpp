// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds the subcommand that merges the JSON of `gloam check` from many machines; `status` receives 0, or 1
// when a failure is in it.
void add_report(CLI::App& app, int& status);

}  // namespace gloam::cli
