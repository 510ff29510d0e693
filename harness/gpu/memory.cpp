// SPDX-License-Identifier: MIT
#include "gpu/internal/memory.hpp"

#include <optional>
#include <stdexcept>

namespace gloam::gpu {
namespace {

std::optional<std::uint32_t> find_type(const vk::PhysicalDeviceMemoryProperties& memory,
                                       std::uint32_t allowed, vk::MemoryPropertyFlags wish) {
    for (std::uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
        const bool fits = (allowed >> i & 1u) != 0;
        if (fits && (memory.memoryTypes[i].propertyFlags & wish) == wish) return i;
    }
    return std::nullopt;
}

std::runtime_error failure(const Context& context, const vk::MemoryRequirements& needs,
                           const std::string& purpose, const char* reason) {
    return std::runtime_error(fmt::format("{}: device \"{}\" {} for the {} bytes it needs", purpose,
                                          context.physical.info.name, reason, needs.size));
}

}  // namespace

vk::raii::DeviceMemory allocate(const Context& context, const vk::MemoryRequirements& needs,
                                std::initializer_list<vk::MemoryPropertyFlags> wishes,
                                const std::string& purpose) {
    std::optional<std::uint32_t> type;
    for (auto wish = wishes.begin(); wish != wishes.end() && !type; ++wish) {
        type = find_type(context.physical.memory, needs.memoryTypeBits, *wish);
    }
    if (!type) throw failure(context, needs, purpose, "has no memory type");
    try {
        return {context.device,
                vk::MemoryAllocateInfo{.allocationSize = needs.size, .memoryTypeIndex = *type}};
    } catch (const vk::SystemError&) {
        throw failure(context, needs, purpose, "has not enough memory");
    }
}

}  // namespace gloam::gpu
