// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "backend/vulkan/device.hpp"
#include "check/answer.hpp"

namespace CLI {
class App;
}

namespace gloam::cli {

// Opens the device of --device and --validation; its pipelines are cached in cache_directory(). Throws like
// gpu::Device.
[[nodiscard]] gpu::Device open_device(const std::string& name, bool validation);

// Prints the validation messages since the last call. Returns the exit status: 0 without messages, otherwise
// 1.
[[nodiscard]] int validation_status(gpu::Device& device);

// Adds --driver to a command that opens devices. Before the command runs, the Vulkan loader gets the
// manifests of these drivers, and of a browser's SwiftShader, unless the environment chooses the drivers
// itself. A driver without a device is an error.
void add_driver_option(CLI::App& command);

// Adds --device, --validation and --driver to a command that runs on one device. The referenced variables
// must live as long as the command.
void add_device_options(CLI::App& command, std::string& device, bool& validation);

// A Vulkan driver without a device, tested in a separate process.
struct DriverTrouble {
    std::filesystem::path manifest;
    check::Reason reason = check::Reason::none;  // crash, hang; error: it is not a driver, or has no device
    std::string error;
    bool asked_for = false;  // by --driver
};

// Drivers that cannot be loaded, and whether another driver has a device.
struct LeftOut {
    std::vector<DriverTrouble> drivers;
    bool others = true;
};

// Those of --driver.
[[nodiscard]] const std::vector<std::filesystem::path>& drivers_asked_for();

// Disables drivers that crash, hang or exit while they load, in this process and those that it starts, as
// long as another driver has a device. Call it while there is only one thread.
[[nodiscard]] LeftOut leave_out_bad_drivers();

// The same for commands that need one device: reports the disabled drivers on standard error. Throws
// std::runtime_error if every driver is disabled.
void require_good_drivers();

// The names of all OpenGL devices. Throws std::runtime_error that says why where there is none.
[[nodiscard]] std::vector<std::string> gl_device_names();

}  // namespace gloam::cli
