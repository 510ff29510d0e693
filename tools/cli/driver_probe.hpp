// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "check/answer.hpp"

namespace gloam::cli {

// A Vulkan driver that gives no device, tried in a process of its own.
struct DriverTrouble {
    std::filesystem::path manifest;
    check::Reason reason = check::Reason::none;  // crash, hang; error: it is no driver, or has no device
    std::string error;
    bool asked_for = false;  // by ask_for_driver()
};

// Drivers that do not even load, and whether another one gives a device.
struct LeftOut {
    std::vector<DriverTrouble> drivers;
    bool others = true;
};

// From now on DriverTrouble says so of this driver.
void ask_for_driver(const std::filesystem::path& manifest);
[[nodiscard]] const std::vector<std::filesystem::path>& drivers_asked_for();

// The manifests of the drivers that the Vulkan loader would load, in its order, from what the environment
// says and from the folders where it looks.
[[nodiscard]] std::vector<std::filesystem::path> driver_manifests();

// Loads this driver alone. Its `reason` is none when it gives a device.
[[nodiscard]] DriverTrouble probe_driver(const std::filesystem::path& manifest);

// Drivers that crash, hang or exit while they load are left out from now on, in this process and those that
// it starts, as long as another one gives a device. To be called from the only thread.
[[nodiscard]] LeftOut leave_out_bad_drivers();

// The same, for commands that need one device: says on standard error which are left out. Throws
// std::runtime_error when every driver is one of them.
void require_good_drivers();

}  // namespace gloam::cli
