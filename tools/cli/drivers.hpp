// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace gloam::cli {

// Adds --driver to a command that opens devices. Before the command runs, the Vulkan loader gets the
// manifests of these drivers, and of a browser's SwiftShader, unless the environment chooses the drivers
// itself. A driver without a device is an error.
void add_driver_option(CLI::App& command);

// Adds --device, --validation and --driver to a command that runs on one device. The referenced variables
// must live as long as the command.
void add_device_options(CLI::App& command, std::string& device, bool& validation);

}  // namespace gloam::cli
