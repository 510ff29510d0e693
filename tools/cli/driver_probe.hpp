// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "check/answer.hpp"

namespace gloam::cli {

// A Vulkan driver without a device, tested in a separate process.
struct DriverTrouble {
    std::filesystem::path manifest;
    check::Reason reason = check::Reason::none;  // crash, hang; error: it is not a driver, or has no device
    std::string error;
    bool asked_for = false;  // by ask_for_driver()
};

// Drivers that cannot be loaded, and whether another driver has a device.
struct LeftOut {
    std::vector<DriverTrouble> drivers;
    bool others = true;
};

// Marks a driver, so that DriverTrouble::asked_for is set for it.
void ask_for_driver(const std::filesystem::path& manifest);
[[nodiscard]] const std::vector<std::filesystem::path>& drivers_asked_for();

// The manifests of the drivers that the Vulkan loader would load, in its order, from the environment and from
// its folders.
[[nodiscard]] std::vector<std::filesystem::path> driver_manifests();

// Loads this driver alone. `reason` is none if it has a device.
[[nodiscard]] DriverTrouble probe_driver(const std::filesystem::path& manifest);

// Disables drivers that crash, hang or exit while they load, in this process and those that it starts, as
// long as another driver has a device. Call it while there is only one thread.
[[nodiscard]] LeftOut leave_out_bad_drivers();

// The same for commands that need one device: reports the disabled drivers on standard error. Throws
// std::runtime_error if every driver is disabled.
void require_good_drivers();

}  // namespace gloam::cli
