// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds the subcommand `bench`, a group: each part measures something of its own. `status` receives what a
// part returns.
void add_bench(CLI::App& app, int& status);

}  // namespace gloam::cli
