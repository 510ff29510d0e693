// SPDX-License-Identifier: MIT
#pragma once

#include "gpu/internal/vulkan.hpp"

namespace gloam::gpu {

// On the device, all later commands see the writes of all earlier ones.
inline void device_barrier(const vk::raii::CommandBuffer& commands) {
    using Access = vk::AccessFlagBits;
    constexpr auto all = vk::PipelineStageFlagBits::eAllCommands;
    commands.pipelineBarrier(all, all, {},
                             vk::MemoryBarrier{.srcAccessMask = Access::eMemoryWrite,
                                               .dstAccessMask = Access::eMemoryRead | Access::eMemoryWrite},
                             nullptr, nullptr);
}

// The host, after waiting, sees the writes of all earlier commands.
inline void host_barrier(const vk::raii::CommandBuffer& commands) {
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eAllCommands, vk::PipelineStageFlagBits::eHost, {},
                             vk::MemoryBarrier{.srcAccessMask = vk::AccessFlagBits::eMemoryWrite,
                                               .dstAccessMask = vk::AccessFlagBits::eHostRead},
                             nullptr, nullptr);
}

}  // namespace gloam::gpu
