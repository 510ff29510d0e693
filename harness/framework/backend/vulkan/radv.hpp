// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "backend/vulkan/commands.hpp"
#include "backend/vulkan/device.hpp"

// Mesa's driver RADV opens a device for a chip that is not there, and compiles for it. Nothing runs.
namespace gloam::backend::vulkan {

enum class DescriptorKind { storage_image, sampled_image, texture, sampler, storage_buffer, uniform_buffer };

// A binding of any set.
struct Descriptor {
    std::uint32_t set = 0;
    std::uint32_t number = 0;
    std::uint32_t count = 1;  // of an array
    DescriptorKind kind = DescriptorKind::storage_image;
};

// A compute shader with the entry point "main".
struct RadvProgram {
    std::span<const std::uint32_t> spirv;
    std::vector<Descriptor> descriptors;
    std::uint32_t push_constant_bytes = 0;
    std::vector<SpecializationConstant> constants;
};

struct RadvReport {
    std::map<std::string, std::uint64_t> statistics;  // by the driver's names, in small letters
    std::string assembly;
    std::vector<std::string> messages;  // of the validation layers, about all: in the first report
};

// The message where RADV is not installed, in one line.
inline constexpr const char* no_radv_message =
    "RADV, Mesa's driver for AMD's GPUs, is not here: install mesa-vulkan-drivers";

// What RADV makes of shaders for a chip of this name (RADV_FORCE_FAMILY). It empties the environment but for
// what finds drivers and layers, so that no option of a user changes the result; and RADV ends the process
// for a name that it does not know. Therefore call it in a process of its own (base::run_apart()), before
// that has used Vulkan. Throws std::runtime_error; vk::SystemError.
[[nodiscard]] std::vector<RadvReport> compiled_by_radv(std::span<const RadvProgram> programs,
                                                       const std::string& chip, Validation validation);

}  // namespace gloam::backend::vulkan
