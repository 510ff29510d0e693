// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds --driver to a command that opens devices. Before the command runs, the Vulkan loader is told of these
// drivers, and of a browser's SwiftShader, unless the environment chooses the drivers itself. One that gives
// no device is an error.
void add_driver_option(CLI::App& command);

}  // namespace gloam::cli
