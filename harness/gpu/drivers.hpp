// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace gloam::gpu {

// Drivers that the Vulkan loader does not find by itself. A driver is specified by its manifest, a small JSON
// file with the path of the driver's library.

// The folders in which Chromium and Chrome keep SwiftShader, a Vulkan driver in software.
[[nodiscard]] std::vector<std::filesystem::path> swiftshader_folders();

// SwiftShader's manifest in the first of these folders that contains it together with its library.
[[nodiscard]] std::optional<std::filesystem::path> find_swiftshader(
    std::span<const std::filesystem::path> folders);
[[nodiscard]] std::optional<std::filesystem::path> find_swiftshader();

// Whether the environment selects the drivers: VK_DRIVER_FILES, VK_ICD_FILENAMES or VK_ADD_DRIVER_FILES is
// set, even if empty.
[[nodiscard]] bool drivers_are_chosen();

// Adds drivers for list_devices() and Device, in this process and those that it starts. It extends the
// environment variables of the Vulkan loader. Call it before anything else of this room, while there is only
// one thread. Throws std::runtime_error with the file's name if it is missing, is not a driver manifest, or
// its library is missing; then nothing has changed.
void add_drivers(std::span<const std::filesystem::path> manifests);

}  // namespace gloam::gpu
