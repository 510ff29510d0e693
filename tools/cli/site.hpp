// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds the subcommand that writes a static site with checks for the visitor's browser.
void add_site(CLI::App& app);

}  // namespace gloam::cli
