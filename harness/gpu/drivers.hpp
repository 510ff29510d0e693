// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace gloam::gpu {

// Drivers that the Vulkan loader does not find by itself. A driver is named by its manifest, a small JSON
// file that names the driver's library.

// Where Chromium and Chrome keep SwiftShader, a Vulkan driver in software that they bring along.
[[nodiscard]] std::vector<std::filesystem::path> swiftshader_folders();

// The manifest of SwiftShader in the first of these folders that has it, and its library beside it.
[[nodiscard]] std::optional<std::filesystem::path> find_swiftshader(
    std::span<const std::filesystem::path> folders);
[[nodiscard]] std::optional<std::filesystem::path> find_swiftshader();

// Whether the environment says which drivers there are: VK_DRIVER_FILES, VK_ICD_FILENAMES or
// VK_ADD_DRIVER_FILES is set, be it to nothing.
[[nodiscard]] bool drivers_are_chosen();

// From now on list_devices() and Device know these drivers, too, in this process and those that it starts:
// the Vulkan loader is told by its environment variables, and what they name already stays. Call it before
// anything else of this room, from the only thread. Throws std::runtime_error that names the file: missing,
// no driver manifest, or its library is missing; nothing has changed then.
void add_drivers(std::span<const std::filesystem::path> manifests);

}  // namespace gloam::gpu
